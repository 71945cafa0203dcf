// SPDX-License-Identifier: Apache-2.0
// HDF5's C API, with owners for its identifiers and exceptions for its failures.
#pragma once

#include <hdf5.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tribo::sweep::hdf5 {

// HDF5 writes the last bytes of an object when the object is closed, so that a close that fails is
// a write that failed. Destructors cannot throw this failure: the first one in this thread is kept
// until take_failed_close() takes it.
void note_failed_close() noexcept;
std::optional<std::string> take_failed_close();

// While such an object lives, HDF5 prints none of its errors in this thread. The object has to be
// made before any other call of HDF5.
class QuietErrors {
 public:
  QuietErrors() {
    // Otherwise HDF5 (1.10.8) tries again at exit to close what it could not close on a full disk,
    // and crashes.
    H5dont_atexit();
    take_failed_close();  // of another file
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;
  ~QuietErrors() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

// HDF5's message on the last call that failed: the system's words ("No space left on device") where
// there are any, else the innermost message.
std::string last_error();

struct Error : std::runtime_error {
  Error() : std::runtime_error(last_error()) {}
  using std::runtime_error::runtime_error;
};

// Checks the result of a call that returns a number below zero when it fails.
template <class T>
T checked(T result) {
  if (result < 0) throw Error();
  return result;
}

// Owns an identifier of any kind.
class Handle {
 public:
  Handle() = default;
  explicit Handle(hid_t id) : id_(checked(id)) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0 && H5Idec_ref(id_) < 0) note_failed_close();
  }
  operator hid_t() const { return id_; }  // NOLINT(google-explicit-constructor)

  // Does as the destructor, but throws where the close fails.
  void close() {
    const hid_t id = std::exchange(id_, H5I_INVALID_HID);
    if (id >= 0) checked(H5Idec_ref(id));
  }

 private:
  hid_t id_ = H5I_INVALID_HID;
};

// A new file at a path, in place of what is there. HDF5's own locks are left out here and in
// open_file(): some file systems have none, and the program has its own.
Handle create_file(const std::string& path);
// Opens a file for reading. Whatever the file says, no other file is read and no library is loaded.
Handle open_file(const std::string& path);
// Are these the first bytes of a file of ours, whose first attribute is the text `format`? A
// process that is killed at any moment leaves such a file: it has only HDF5's head, as when the
// file is made, or the text in the first bytes behind the head.
bool is_start_of(std::span<const std::byte> start, std::string_view format);

// The types of numbers in files and in memory. Texts are of UTF-8, of any length.
inline hid_t file_type(double) { return H5T_IEEE_F64LE; }
inline hid_t file_type(std::uint64_t) { return H5T_STD_U64LE; }
inline hid_t memory_type(double) { return H5T_NATIVE_DOUBLE; }
inline hid_t memory_type(std::uint64_t) { return H5T_NATIVE_UINT64; }
Handle string_type();

// Groups, datasets and attributes are made without times, so that files of one content are equal.
Handle make_group(hid_t parent, const std::string& name);
Handle make_dataset(hid_t parent, const std::string& name, hid_t type, hid_t space, hid_t creation);
void without_times(hid_t creation);

// Stores numbers as a dataset in chunks of whole rows, about 1 MB each: HDF5 has checksums of
// chunks only.
template <class T>
Handle write_array(hid_t group, const std::string& name, const std::vector<T>& values,
                   std::vector<hsize_t> extents) {
  const Handle space(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr));
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE));
  const hsize_t row = std::max<hsize_t>(values.size() / extents.front(), 1) * sizeof(T);
  extents.front() = std::clamp<hsize_t>((std::size_t{1} << 20) / row, 1, extents.front());
  checked(H5Pset_chunk(creation, static_cast<int>(extents.size()), extents.data()));
  checked(H5Pset_fletcher32(creation));
  Handle dataset = make_dataset(group, name, file_type(T()), space, creation);
  checked(H5Dwrite(dataset, memory_type(T()), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
  return dataset;
}

void write_attribute(hid_t object, const char* name, std::string_view text);
void write_attribute(hid_t object, const char* name, std::span<const std::string> texts);
void write_attribute(hid_t object, const char* name, double value);
void write_attribute(hid_t object, const char* name, std::uint64_t value);
// Makes `scale` the dimension scale of the second dimension of `datasets`, which have two, by
// HDF5's "Dimension Scale Specification".
void make_scale(hid_t scale, const char* name, std::span<const hid_t> datasets);
// These functions throw Error where there is no attribute of that name, type and shape.
std::string read_text(hid_t object, const char* name);
std::vector<std::string> read_texts(hid_t object, const char* name);
std::uint64_t read_count(hid_t object, const char* name);

}  // namespace tribo::sweep::hdf5
