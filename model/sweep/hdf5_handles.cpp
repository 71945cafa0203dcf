// SPDX-License-Identifier: Apache-2.0
#include "sweep/hdf5_handles.hpp"

#include <array>
#include <cstddef>

namespace tribo::sweep::hdf5 {
namespace {

// Called from the innermost message outwards. HDF5's texts have the system's word among much else:
// "file write failed: time = …, errno = 28, error message = 'No space left on device', buf = …".
herr_t note_message(unsigned, const H5E_error2_t* error, void* noted) {
  constexpr std::string_view before = "error message = '";
  auto& message = *static_cast<std::string*>(noted);
  const std::string_view text = error->desc == nullptr ? "" : error->desc;
  const std::size_t found = text.find(before);
  if (found != text.npos) {
    const std::string_view rest = text.substr(found + before.size());
    message = rest.substr(0, rest.find('\''));
    return 1;
  }
  if (message.empty()) message = text;
  return 0;
}

Handle utf8_names() {
  Handle list(H5Pcreate(H5P_LINK_CREATE));
  checked(H5Pset_char_encoding(list, H5T_CSET_UTF8));
  return list;
}

Handle scalar() { return Handle(H5Screate(H5S_SCALAR)); }

void write_attribute(hid_t object, const char* name, hid_t file_type, hid_t memory_type,
                     hid_t space, const void* value) {
  Handle attribute(H5Acreate2(object, name, file_type, space, H5P_DEFAULT, H5P_DEFAULT));
  checked(H5Awrite(attribute, memory_type, value));
}

Handle access_without_locks() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS));
  checked(H5Pset_fclose_degree(access, H5F_CLOSE_STRONG));
#if H5_VERSION_GE(1, 10, 7)
  checked(H5Pset_file_locking(access, false, true));
#endif
  return access;
}

constexpr hssize_t most_texts = 1'000'000;

// The number of an attribute's values. Throws Error where its rank is another; rank 0: a scalar.
std::size_t length_of(hid_t attribute, hid_t space, int rank) {
  const H5S_class_t kind = rank == 0 ? H5S_SCALAR : H5S_SIMPLE;
  if (H5Sget_simple_extent_type(space) != kind ||
      checked(H5Sget_simple_extent_ndims(space)) != rank)
    throw Error("an attribute is of another shape than those that tribocheck writes");
  const hssize_t count = checked(H5Sget_simple_extent_npoints(space));
  if (count > most_texts || checked(H5Aget_storage_size(attribute)) > hsize_t{most_texts} * 16)
    throw Error("an attribute is longer than those that tribocheck writes");
  return static_cast<std::size_t>(count);
}

// Strings that HDF5 has allocated.
class ReadStrings {
 public:
  ReadStrings(hid_t attribute, int rank) : type_(string_type()), space_(H5Aget_space(attribute)) {
    const Handle type(H5Aget_type(attribute));
    if (H5Tget_class(type) != H5T_STRING || checked(H5Tis_variable_str(type)) == 0)
      throw Error("an attribute is no text of variable length");
    texts_.resize(length_of(attribute, space_, rank), nullptr);
    checked(H5Aread(attribute, type_, texts_.data()));
  }
  ReadStrings(const ReadStrings&) = delete;
  ReadStrings& operator=(const ReadStrings&) = delete;
  ~ReadStrings() { H5Dvlen_reclaim(type_, space_, H5P_DEFAULT, texts_.data()); }

  std::vector<std::string> texts() const {
    std::vector<std::string> copies;
    for (const char* const text : texts_) copies.emplace_back(text == nullptr ? "" : text);
    return copies;
  }

 private:
  Handle type_, space_;
  std::vector<char*> texts_;
};

thread_local std::optional<std::string> failed_close;

}  // namespace

void note_failed_close() noexcept {
  if (failed_close) return;
  failed_close.emplace();
  try {
    *failed_close = last_error();
  } catch (...) {  // no room for the text
  }
}

std::optional<std::string> take_failed_close() { return std::exchange(failed_close, std::nullopt); }

std::string last_error() {
  std::string message;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, note_message, &message);
  return message.empty() ? "HDF5 does not say why" : message;
}

Handle create_file(const std::string& path) {
  const Handle creation(H5Pcreate(H5P_FILE_CREATE));
  without_times(creation);
  checked(H5Pset_link_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
  const Handle access = access_without_locks();
  // HDF5 1.8 can read the file, whatever version writes it.
  checked(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18));
  return Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access));
}

Handle open_file(const std::string& path) {
  H5PLset_loading_state(0);
  if (H5Lis_registered(H5L_TYPE_EXTERNAL) > 0) H5Lunregister(H5L_TYPE_EXTERNAL);
  return Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access_without_locks()));
}

bool is_start_of(std::span<const std::byte> start, std::string_view format) {
  constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
  constexpr std::size_t head = 48;
  const std::string_view text(reinterpret_cast<const char*>(start.data()), start.size());
  return text.starts_with(signature) && (text.size() <= head || text.find(format) != text.npos);
}

Handle string_type() {
  Handle type(H5Tcopy(H5T_C_S1));
  checked(H5Tset_size(type, H5T_VARIABLE));
  checked(H5Tset_cset(type, H5T_CSET_UTF8));
  return type;
}

void without_times(hid_t creation) { checked(H5Pset_obj_track_times(creation, false)); }

Handle make_group(hid_t parent, const std::string& name) {
  Handle creation(H5Pcreate(H5P_GROUP_CREATE));
  without_times(creation);
  checked(H5Pset_link_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
  return Handle(H5Gcreate2(parent, name.c_str(), utf8_names(), creation, H5P_DEFAULT));
}

Handle make_dataset(hid_t parent, const std::string& name, hid_t type, hid_t space,
                    hid_t creation) {
  without_times(creation);
  return Handle(H5Dcreate2(parent, name.c_str(), type, space, utf8_names(), creation, H5P_DEFAULT));
}

void write_attribute(hid_t object, const char* name, std::string_view text) {
  const std::string copy(text);
  const char* const first = copy.c_str();
  const Handle type = string_type();
  write_attribute(object, name, type, type, scalar(), &first);
}

void write_attribute(hid_t object, const char* name, std::span<const std::string> texts) {
  std::vector<const char*> firsts;
  for (const std::string& text : texts) firsts.push_back(text.c_str());
  const hsize_t count = texts.size();
  const Handle space(H5Screate_simple(1, &count, nullptr));
  const Handle type = string_type();
  write_attribute(object, name, type, type, space, firsts.data());
}

void write_attribute(hid_t object, const char* name, double value) {
  write_attribute(object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, scalar(), &value);
}

void write_attribute(hid_t object, const char* name, std::uint64_t value) {
  write_attribute(object, name, H5T_STD_U64LE, H5T_NATIVE_UINT64, scalar(), &value);
}

// HDF5's own functions for this write the undefined bytes in the gap of a struct, so that no two
// files would be equal.
void make_scale(hid_t scale, const char* name, std::span<const hid_t> datasets) {
  for (const auto& [attribute, text] :
       {std::pair{"CLASS", std::string("DIMENSION_SCALE")}, std::pair{"NAME", std::string(name)}}) {
    const Handle type(H5Tcopy(H5T_C_S1));
    checked(H5Tset_size(type, text.size() + 1));
    write_attribute(scale, attribute, type, type, scalar(), text.c_str());
  }
  const auto reference_to = [](hid_t object) {
    hobj_ref_t reference = 0;
    checked(H5Rcreate(&reference, object, ".", H5R_OBJECT, H5I_INVALID_HID));
    return reference;
  };
  struct Use {
    hobj_ref_t dataset;
    int dimension, gap;
  };
  std::vector<Use> uses;
  hobj_ref_t to_scale = reference_to(scale);
  const Handle list_type(H5Tvlen_create(H5T_STD_REF_OBJ));
  const hsize_t dimensions = 2;
  const Handle list_space(H5Screate_simple(1, &dimensions, nullptr));
  for (const hid_t dataset : datasets) {
    const std::array<hvl_t, 2> lists{hvl_t{0, nullptr}, hvl_t{1, &to_scale}};
    write_attribute(dataset, "DIMENSION_LIST", list_type, list_type, list_space, lists.data());
    uses.push_back({reference_to(dataset), 1, 0});
  }
  const Handle use_type(H5Tcreate(H5T_COMPOUND, sizeof(Use)));
  checked(H5Tinsert(use_type, "dataset", offsetof(Use, dataset), H5T_STD_REF_OBJ));
  checked(H5Tinsert(use_type, "dimension", offsetof(Use, dimension), H5T_NATIVE_INT));
  const hsize_t count = uses.size();
  const Handle use_space(H5Screate_simple(1, &count, nullptr));
  write_attribute(scale, "REFERENCE_LIST", use_type, use_type, use_space, uses.data());
}

std::string read_text(hid_t object, const char* name) {
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT));
  return ReadStrings(attribute, 0).texts().front();
}

std::vector<std::string> read_texts(hid_t object, const char* name) {
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT));
  return ReadStrings(attribute, 1).texts();
}

std::uint64_t read_count(hid_t object, const char* name) {
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT));
  const Handle type(H5Aget_type(attribute)), space(H5Aget_space(attribute));
  length_of(attribute, space, 0);
  if (checked(H5Tequal(type, H5T_STD_U64LE)) == 0) throw Error("an attribute is no count");
  std::uint64_t value = 0;
  checked(H5Aread(attribute, H5T_NATIVE_UINT64, &value));
  return value;
}

}  // namespace tribo::sweep::hdf5
