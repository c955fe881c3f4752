#include "apps/export/zip.hpp"

#include <zip.h>

#include <memory>

#include "specimen/body/error.hpp"

namespace exchange {
namespace {

constexpr zip_uint16_t first_day = 1 << 5 | 1;  ///< 1 January 1980 as ZIP writes days

struct Discard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Archive = std::unique_ptr<zip_t, Discard>;
using Source = std::unique_ptr<zip_source_t, Discard>;

[[noreturn]] void fail(const std::string& path, const char* reason) {
  throw specimen::Error(path, std::string("cannot be written as ZIP: ") + reason, "", "",
                        specimen::Fault::write);
}

void add(const std::string& path, zip_t* archive, const NamedBytes& file) {
  Source source(zip_source_buffer(archive, file.bytes.data(), file.bytes.size(), 0));
  const zip_int64_t index =
      source ? zip_file_add(archive, file.name.c_str(), source.get(), ZIP_FL_ENC_UTF_8) : -1;
  if (index < 0) fail(path, zip_strerror(archive));
  (void)source.release();  // belongs to the archive now
  if (zip_file_set_dostime(archive, static_cast<zip_uint64_t>(index), 0, first_day, 0) != 0)
    fail(path, zip_strerror(archive));
}

std::string read_all(const std::string& path, zip_source_t* source) {
  zip_stat_t size;
  if (zip_source_stat(source, &size) != 0 || zip_source_open(source) != 0)
    fail(path, zip_error_strerror(zip_source_error(source)));
  std::string bytes(size.size, '\0');
  const zip_int64_t count = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (count != static_cast<zip_int64_t>(bytes.size())) fail(path, "it is cut off");
  return bytes;
}

}  // namespace

std::string zipped(const std::string& path, const std::vector<NamedBytes>& files) {
  zip_error_t error;
  zip_error_init(&error);
  const Source memory(zip_source_buffer_create(nullptr, 0, 0, &error));
  if (!memory) fail(path, zip_error_strerror(&error));
  Archive archive(zip_open_from_source(memory.get(), ZIP_TRUNCATE, &error));
  if (!archive) fail(path, zip_error_strerror(&error));
  zip_source_keep(memory.get());  // the archive takes it, and it is read afterwards
  for (const NamedBytes& file : files) add(path, archive.get(), file);
  if (zip_close(archive.get()) != 0) fail(path, zip_strerror(archive.get()));
  (void)archive.release();  // closed
  return read_all(path, memory.get());
}

}  // namespace exchange
