#include "record/mcap.hpp"

#include <algorithm>
#include <array>
#include <concepts>

#include "base/whole_file.hpp"
#include "burnish/base/error.hpp"

namespace burnish {
namespace {

constexpr std::string_view magic = "\x89MCAP0\r\n";
constexpr std::size_t chunk_size = std::size_t{1} << 20U;  // Minimum; chosen by hand [bytes]

enum class Op : std::uint8_t {
  Header = 0x01,
  Footer = 0x02,
  Schema = 0x03,
  Channel = 0x04,
  Message = 0x05,
  Chunk = 0x06,
  MessageIndex = 0x07,
  ChunkIndex = 0x08,
  Statistics = 0x0B,
  Metadata = 0x0C,
  MetadataIndex = 0x0D,
  SummaryOffset = 0x0E,
  DataEnd = 0x0F,
};

constexpr std::array<std::uint32_t, 256> make_crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t c = i;
    for (int bit = 0; bit < 8; ++bit) c = (c & 1U) != 0 ? 0xEDB88320U ^ (c >> 1U) : c >> 1U;
    table[i] = c;
  }
  return table;
}

/// Fields of a record, one after the other, little-endian.
class Bytes {
 public:
  template <std::unsigned_integral T>
  Bytes& put(T value) {
    for (std::size_t i = 0; i < sizeof value; ++i)
      bytes_ += static_cast<char>(static_cast<unsigned char>(value >> (8 * i)));
    return *this;
  }
  /// Appends a text, preceded by its length.
  Bytes& put(std::string_view text) {
    put(static_cast<std::uint32_t>(text.size()));
    return raw(text);
  }
  Bytes& raw(std::string_view bytes) {
    bytes_ += bytes;
    return *this;
  }
  template <class Key, class Value>
  Bytes& put(const std::map<Key, Value>& entries) {
    Bytes inside;
    for (const auto& [key, value] : entries) inside.put(key).put(value);
    return put(std::string_view(inside.bytes_));
  }
  Bytes& put(const std::string& text) { return put(std::string_view(text)); }
  /// Returns the fields as a record: kind and length, then the fields.
  std::string record(Op op) const {
    Bytes head;
    head.put(static_cast<std::uint8_t>(op)).put(static_cast<std::uint64_t>(bytes_.size()));
    return head.bytes_ + bytes_;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

std::uint16_t number_after(const std::vector<std::string>& records) {
  return static_cast<std::uint16_t>(records.size() + 1);
}

void check_known(const char* what, std::uint16_t number, std::size_t count) {
  if (number < 1 || number > count)
    throw Error("mcap: " + std::string(what) + " " + std::to_string(number) +
                " does not exist; wanted 1 to " + std::to_string(count));
}

}  // namespace

std::uint32_t crc32(std::string_view bytes, std::uint32_t before) {
  static constexpr std::array<std::uint32_t, 256> table = make_crc_table();
  std::uint32_t crc = ~before;
  for (const char byte : bytes)
    crc = table[(crc ^ static_cast<unsigned char>(byte)) & 0xFFU] ^ (crc >> 8U);
  return ~crc;
}

McapWriter::McapWriter(const std::filesystem::path& file, std::string_view library)
    : file_(std::make_unique<WholeFile>(file)) {
  put(magic);
  put(Bytes().put(std::string_view()).put(library).record(Op::Header));
}

McapWriter::~McapWriter() = default;

void McapWriter::put(std::string_view bytes) {
  file_->stream().write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  data_crc_ = crc32(bytes, data_crc_);
  position_ += bytes.size();
}

std::uint16_t McapWriter::add_schema(std::string_view name, std::string_view json_schema) {
  const std::uint16_t number = number_after(schemas_);
  schemas_.push_back(Bytes()
                         .put(number)
                         .put(name)
                         .put(std::string_view("jsonschema"))
                         .put(json_schema)
                         .record(Op::Schema));
  chunk_ += schemas_.back();
  return number;
}

std::uint16_t McapWriter::add_channel(std::uint16_t schema, std::string_view topic) {
  check_known("schema", schema, schemas_.size());
  const std::uint16_t number = number_after(channels_);
  channels_.push_back(Bytes()
                          .put(number)
                          .put(schema)
                          .put(topic)
                          .put(std::string_view("json"))
                          .put(std::map<std::string, std::string>())
                          .record(Op::Channel));
  chunk_ += channels_.back();
  counts_[number] = 0;
  return number;
}

void McapWriter::write(std::uint16_t channel, std::uint64_t time, std::string_view json) {
  check_known("channel", channel, channels_.size());
  if (chunk_index_.empty()) chunk_start_ = chunk_end_ = time;
  chunk_start_ = std::min(chunk_start_, time);
  chunk_end_ = std::max(chunk_end_, time);
  start_ = messages_ == 0 ? time : std::min(start_, time);
  end_ = std::max(end_, time);
  chunk_index_[channel].emplace_back(time, chunk_.size());
  chunk_ += Bytes().put(channel).put(messages_).put(time).put(time).raw(json).record(Op::Message);
  ++counts_[channel];
  ++messages_;
  if (chunk_.size() >= chunk_size) close_chunk();
}

void McapWriter::close_chunk() {
  if (chunk_index_.empty()) return;
  const auto size = static_cast<std::uint64_t>(chunk_.size());
  ChunkIndex index{chunk_start_, chunk_end_, position_, 0, 0, size, {}};
  put(Bytes()
          .put(chunk_start_)
          .put(chunk_end_)
          .put(size)
          .put(crc32(chunk_))
          .put(std::string_view())  // no compression
          .put(size)
          .raw(chunk_)
          .record(Op::Chunk));
  index.length = position_ - index.offset;
  const std::uint64_t indexes = position_;
  for (const auto& [channel, entries] : chunk_index_) {
    index.index_offsets[channel] = position_;
    Bytes list;
    for (const auto& [time, offset] : entries) list.put(time).put(offset);
    put(Bytes().put(channel).put(std::string_view(list.bytes())).record(Op::MessageIndex));
  }
  index.index_length = position_ - indexes;
  chunks_.push_back(std::move(index));
  chunk_.clear();
  chunk_index_.clear();
}

void McapWriter::add_metadata(std::string_view name,
                              const std::map<std::string, std::string>& values) {
  const std::uint64_t offset = position_;
  put(Bytes().put(name).put(values).record(Op::Metadata));
  metadata_.push_back({offset, position_ - offset, std::string(name)});
}

void McapWriter::write_summary() {
  std::string summary, offsets;
  const std::uint64_t summary_start = position_;
  const auto group = [&](Op op, const std::vector<std::string>& records) {
    if (records.empty()) return;
    const std::uint64_t start = summary_start + summary.size();
    for (const std::string& record : records) summary += record;
    offsets += Bytes()
                   .put(static_cast<std::uint8_t>(op))
                   .put(start)
                   .put(summary_start + summary.size() - start)
                   .record(Op::SummaryOffset);
  };
  group(Op::Schema, schemas_);
  group(Op::Channel, channels_);
  group(Op::Statistics, {Bytes()
                             .put(static_cast<std::uint64_t>(messages_))
                             .put(static_cast<std::uint16_t>(schemas_.size()))
                             .put(static_cast<std::uint32_t>(channels_.size()))
                             .put(std::uint32_t{0})  // attachments
                             .put(static_cast<std::uint32_t>(metadata_.size()))
                             .put(static_cast<std::uint32_t>(chunks_.size()))
                             .put(start_)
                             .put(end_)
                             .put(counts_)
                             .record(Op::Statistics)});
  std::vector<std::string> records;
  for (const ChunkIndex& chunk : chunks_)
    records.push_back(Bytes()
                          .put(chunk.start_time)
                          .put(chunk.end_time)
                          .put(chunk.offset)
                          .put(chunk.length)
                          .put(chunk.index_offsets)
                          .put(chunk.index_length)
                          .put(std::string_view())
                          .put(chunk.size)
                          .put(chunk.size)
                          .record(Op::ChunkIndex));
  group(Op::ChunkIndex, records);
  records.clear();
  for (const MetadataIndex& entry : metadata_)
    records.push_back(
        Bytes().put(entry.offset).put(entry.length).put(entry.name).record(Op::MetadataIndex));
  group(Op::MetadataIndex, records);

  const std::uint64_t offset_start = summary_start + summary.size();
  Bytes footer;
  footer.put(summary_start).put(offset_start);
  // The checksum covers the summary and the footer up to the checksum itself.
  Bytes head;
  head.put(static_cast<std::uint8_t>(Op::Footer)).put(std::uint64_t{20});
  const std::uint32_t crc = crc32(summary + offsets + head.bytes() + footer.bytes());
  put(summary + offsets + footer.put(crc).record(Op::Footer));
}

void McapWriter::finish() {
  close_chunk();
  put(Bytes().put(data_crc_).record(Op::DataEnd));
  write_summary();
  put(magic);
  file_->keep();
}

}  // namespace burnish
