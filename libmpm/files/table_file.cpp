#include "libmpm/files/table_file.hpp"

#include <algorithm>

#include "libmpm/files/hdf5_write.hpp"
#include "libmpm/files/replace_file.hpp"
#include "libmpm/scene/error.hpp"

namespace mpm {
namespace {

using namespace hdf5;

/// Text of a fixed length, filled up with zeros: what stands in the file are the letters themselves, so that
/// the same texts give the same bytes.
Handle fixed_text(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "out of memory");
  H5Tset_size(type, length);
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

void write_column(hid_t file, const TableColumn& column, const std::vector<std::string>& texts) {
  std::size_t length = 1;
  for (const std::string& text : texts) length = std::max(length, text.size());
  std::string letters;
  for (const std::string& text : texts) letters += text + std::string(length - text.size(), '\0');
  const Handle type = fixed_text(length);
  write_dataset(file, column.name, {texts.size()}, type, type, letters.data(), {column.unit, column.meaning});
}

template <class T>
void write_column(hid_t file, const TableColumn& column, const std::vector<T>& numbers) {
  write_values(file, column.name, {numbers.size()}, numbers.data(), {column.unit, column.meaning});
}

}  // namespace

std::size_t TableColumn::rows() const {
  return std::visit([](const auto& list) { return list.size(); }, values);
}

void write_table(const std::string& path, const std::vector<TableColumn>& columns) try {
  const Quiet quiet;
  const Handle file = memory_file();
  write_text(file, "format", "mesopix-table");
  write_number(file, "format_version", std::int64_t{1});
  for (const TableColumn& column : columns)
    std::visit([&](const auto& list) { write_column(file, column, list); }, column.values);
  replace_file(path, image_of(file));
} catch (const Fault& fault) {
  throw FileError(path, fault.what(), "");
}

}  // namespace mpm
