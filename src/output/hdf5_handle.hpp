// Identifiers of HDF5 that close themselves, and calls that fail as exceptions.
#pragma once

#include <hdf5.h>

#include <stdexcept>
#include <string>

namespace gearfilm {

inline void hdf5_check(herr_t status, const char* what) {
  if (status < 0) throw std::runtime_error(std::string("HDF5 cannot ") + what);
}

inline hid_t hdf5_valid(hid_t id, const char* what) {
  if (id < 0) throw std::runtime_error(std::string("HDF5 cannot ") + what);
  return id;
}

/// Closes its identifier at the end of a scope.
class Hdf5Handle {
public:
  Hdf5Handle(hid_t id, herr_t (*close)(hid_t), const char* what) : id_(hdf5_valid(id, what)), close_(close) {}
  ~Hdf5Handle() { close_(id_); }
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  operator hid_t() const { return id_; }

private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

}  // namespace gearfilm
