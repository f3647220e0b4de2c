// Identifiers of HDF5 that are closed at their end, and its error messages switched off. Only the
// sources that talk to HDF5 include this.
#pragma once

#include <hdf5.h>
#include <string>
#include <utility>

#include "sim/base/formatted.h"

namespace prehend {

// An identifier of a file, a data set, a type, ...; negative: the call that made it failed.
class Hdf5Id {
 public:
  using Close = herr_t (*)(hid_t);

  Hdf5Id(hid_t id, Close close) : id_(id), close_(close) {}
  Hdf5Id(Hdf5Id&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5Id(const Hdf5Id&) = delete;
  Hdf5Id& operator=(const Hdf5Id&) = delete;
  Hdf5Id& operator=(Hdf5Id&&) = delete;
  ~Hdf5Id() {
    if (id_ >= 0) close_(id_);
  }

  bool valid() const { return id_ >= 0; }
  hid_t id() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

// The name of a file in memory that belongs to the object at this address. HDF5 takes two of the
// same name, open at the same time, for the same file.
inline std::string name_in_memory(const void* owner) { return formatted("memory %p", owner); }

// While one lives, HDF5 prints nothing to stderr about calls of this thread that fail.
class QuietHdf5 {
 public:
  QuietHdf5() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  QuietHdf5(const QuietHdf5&) = delete;
  QuietHdf5& operator=(const QuietHdf5&) = delete;
  ~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

}  // namespace prehend
