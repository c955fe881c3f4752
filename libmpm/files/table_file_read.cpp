#include <algorithm>

#include "libmpm/files/hdf5_read.hpp"
#include "libmpm/files/table_file.hpp"
#include "libmpm/scene/error.hpp"

namespace mpm {
namespace {

using namespace hdf5;

std::vector<std::string> names_in(hid_t file) {
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t* link, void* all) -> herr_t {
    if (link->type != H5L_TYPE_HARD) return -1;
    static_cast<std::vector<std::string>*>(all)->emplace_back(name);
    return 0;
  };
  require(H5Literate(file, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names) >= 0,
          "holds a link to somewhere else, or is damaged");
  return names;
}

template <class T>
std::vector<T> read_numbers(hid_t file, const TableColumn& column) {
  std::vector<T> values;
  read_values<T>(file, column.name, 1, column.unit, [&](const std::vector<hsize_t>& extent) {
    values.resize(extent[0]);
    return values.data();
  });
  return values;
}

std::vector<std::string> read_texts(hid_t file, const TableColumn& column, hid_t type) {
  const std::size_t length = H5Tget_size(type);
  const Dataset dataset = open_dataset(file, column.name, 1, H5T_STRING, length);
  require(H5Tis_variable_str(type) == 0, dataset.words + " has a wrong type");
  std::string letters(length * dataset.extent[0], '\0');
  read_all(dataset, type, letters.data());
  std::vector<std::string> texts;
  for (std::size_t at = 0; at < letters.size(); at += length)
    texts.emplace_back(letters.substr(at, length).c_str());  // up to the zeros that fill it
  return texts;
}

TableColumn read_column(hid_t file, const std::string& name) {
  const Handle dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, name + " is not a dataset");
  const Handle type(H5Dget_type(dataset), H5Tclose, name + " is damaged");
  TableColumn column{name, read_text(dataset, "unit"), read_text(dataset, "meaning"), {}};
  if (H5Tget_class(type) == H5T_FLOAT)
    column.values = read_numbers<double>(file, column);
  else if (H5Tget_class(type) == H5T_INTEGER)
    column.values = read_numbers<std::int64_t>(file, column);
  else
    column.values = read_texts(file, column, type);
  return column;
}

}  // namespace

std::vector<TableColumn> read_table(const std::string& path) try {
  const Quiet quiet;
  const Handle file = open_file(path);
  require(H5Aexists(file, "format") > 0 && read_text(file, "format") == "mesopix-table",
          "is not a mesopix table");
  std::vector<TableColumn> columns;
  for (const std::string& name : names_in(file)) columns.push_back(read_column(file, name));
  for (const TableColumn& column : columns)
    require(column.rows() == columns.front().rows(), "has columns of other lengths");
  return columns;
} catch (const Fault& fault) {
  throw FileError(path, fault.what(), "must be a table.h5 that mesopix wrote", "collect the study again");
}

}  // namespace mpm
