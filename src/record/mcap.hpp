// Recordings in MCAP, a container format for time-stamped messages that robotics tools such as
// Foxglove open (https://mcap.dev/spec).
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

/// Writer of one MCAP file: schemas, channels, then messages in the order of their times. Messages
/// are stored in uncompressed chunks with checksums, and indexes let readers jump to any time.
class McapWriter {
 public:
  /// `library` names the program that writes the file. Throws Error if the file cannot be written.
  McapWriter(const std::filesystem::path& file, std::string_view library);
  /// Discards the file unless finish() was called.
  ~McapWriter();
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  /// Adds a schema in JSON Schema and returns its number.
  std::uint16_t add_schema(std::string_view name, std::string_view json_schema);
  /// Adds a topic of JSON messages and returns its number. Throws Error if `schema` does not exist.
  std::uint16_t add_channel(std::uint16_t schema, std::string_view topic);
  /// Writes a message. `time` counts from 1970 [ns]. Throws Error if `channel` does not exist.
  void write(std::uint16_t channel, std::uint64_t time, std::string_view json);
  void add_metadata(std::string_view name, const std::map<std::string, std::string>& values);
  /// Writes the end of the file. Throws Error if anything could not be written.
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
  std::uint64_t position_ = 0;  ///< Number of bytes written
  std::uint32_t data_crc_ = 0;
  std::string chunk_;                              ///< Records of the current chunk
  std::uint64_t chunk_start_ = 0, chunk_end_ = 0;  ///< First and last time in the chunk [ns]
  std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>> chunk_index_;
  std::vector<std::string> schemas_, channels_;  ///< Records of the schemas and channels
  std::map<std::uint16_t, std::uint64_t> counts_;
  std::vector<ChunkIndex> chunks_;
  std::vector<MetadataIndex> metadata_;
  std::uint64_t start_ = 0, end_ = 0;  ///< First and last time of all messages [ns]
  std::uint32_t messages_ = 0;
};

/// CRC-32 as in zip and PNG files. `before` is the CRC of the preceding bytes.
std::uint32_t crc32(std::string_view bytes, std::uint32_t before = 0);

}  // namespace burnish
