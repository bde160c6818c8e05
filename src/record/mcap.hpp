// Recordings in MCAP, the container for time-stamped messages that robotics tools such as Foxglove
// open (https://mcap.dev/spec).
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burnish {

class WholeFile;

/// Writes one file: schemas, channels, then messages in the order of their times. Messages are
/// gathered in uncompressed chunks with their checksums and indexes, so that readers can jump.
class McapWriter {
 public:
  /// `library`: what wrote it. Throws Error if the file cannot be written.
  McapWriter(const std::filesystem::path& file, std::string_view library);
  /// Without finish() there is no file.
  ~McapWriter();
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  /// A schema in JSON Schema; its number.
  std::uint16_t add_schema(std::string_view name, std::string_view json_schema);
  /// A topic of messages in JSON; its number. Throws Error for a schema that there is not.
  std::uint16_t add_channel(std::uint16_t schema, std::string_view topic);
  /// time: ns since 1970. Throws Error for a channel that there is not.
  void write(std::uint16_t channel, std::uint64_t time, std::string_view json);
  void add_metadata(std::string_view name, const std::map<std::string, std::string>& values);
  /// Writes what is at the end. Throws Error if anything could not be written.
  void finish();

 private:
  struct ChunkIndex {
    std::uint64_t start_time, end_time, offset, length, index_length, size;
    std::map<std::uint16_t, std::uint64_t> index_offsets;
  };
  struct MetadataIndex {
    std::uint64_t offset, length;
    std::string name;
  };

  void put(std::string_view bytes);
  void close_chunk();
  void write_summary();

  std::unique_ptr<WholeFile> file_;
  std::uint64_t position_ = 0;  ///< bytes written
  std::uint32_t data_crc_ = 0;
  std::string chunk_;                              ///< records of the chunk that is being filled
  std::uint64_t chunk_start_ = 0, chunk_end_ = 0;  ///< ns
  std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>> chunk_index_;
  std::vector<std::string> schemas_, channels_;  ///< their records
  std::map<std::uint16_t, std::uint64_t> counts_;
  std::vector<ChunkIndex> chunks_;
  std::vector<MetadataIndex> metadata_;
  std::uint64_t start_ = 0, end_ = 0;  ///< ns, of all messages
  std::uint32_t messages_ = 0;
};

/// CRC-32 as of zip and PNG files; `before`: of what came before.
std::uint32_t crc32(std::string_view bytes, std::uint32_t before = 0);

}  // namespace burnish
