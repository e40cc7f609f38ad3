#include "output/checkpoint/hdf5_archive.hpp"

#include <fmt/core.h>
#include <hdf5.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

namespace moraine {
namespace {

/// Throws unless HDF5 reports success (ids and statuses are negative on failure).
template <class Status>
Status expect_good(Status status, std::string const& what) {
  if (status >= 0) return status;
  std::string const system = errno != 0 ? std::string(": ") + std::strerror(errno) : "";
  throw std::runtime_error(what + system);
}

/// An HDF5 object that closes itself.
class Handle {
 public:
  Handle(hid_t id, herr_t (*closer)(hid_t), std::string const& what)
      : id_(expect_good(id, what)), closer_(closer) {}
  ~Handle() {
    if (id_ >= 0) closer_(id_);
  }
  Handle(Handle const&) = delete;
  Handle& operator=(Handle const&) = delete;
  operator hid_t() const { return id_; }

  /// Closes now: buffered data reach the file only then, or fail to.
  void close(std::string const& what) {
    hid_t const id = id_;
    id_ = -1;
    expect_good(closer_(id), what);
  }

 private:
  hid_t id_;
  herr_t (*closer_)(hid_t);
};

hid_t type_of(double) { return H5T_NATIVE_DOUBLE; }
hid_t type_of(std::uint64_t) { return H5T_NATIVE_UINT64; }
hid_t type_of(std::uint32_t) { return H5T_NATIVE_UINT32; }
hid_t type_of(std::int32_t) { return H5T_NATIVE_INT32; }
hid_t type_of(std::uint8_t) { return H5T_NATIVE_UINT8; }
hid_t type_of(char) { return H5T_NATIVE_CHAR; }

/// Numbers and texts are arrays too; only the arrays themselves differ by direction.
class Hdf5Archive : public Archive {
 public:
  explicit Hdf5Archive(std::string path) : path_(std::move(path)) {}

  void array(std::string_view name, std::string_view unit, std::vector<double>& values) override {
    exchange(name, unit, values);
  }
  void array(std::string_view name, std::string_view unit,
             std::vector<std::uint64_t>& values) override {
    exchange(name, unit, values);
  }
  void array(std::string_view name, std::string_view unit,
             std::vector<std::uint32_t>& values) override {
    exchange(name, unit, values);
  }
  void array(std::string_view name, std::string_view unit,
             std::vector<std::int32_t>& values) override {
    exchange(name, unit, values);
  }
  void array(std::string_view name, std::string_view unit,
             std::vector<std::uint8_t>& values) override {
    exchange(name, unit, values);
  }
  void number(std::string_view name, double& value) override { exchange_number(name, value); }
  void number(std::string_view name, std::uint64_t& value) override {
    exchange_number(name, value);
  }
  void text(std::string_view name, std::string& value) override {
    std::vector<char> letters(value.begin(), value.end());
    exchange(name, "", letters);
    value.assign(letters.begin(), letters.end());
  }

 protected:
  std::string about(std::string_view name) const { return fmt::format("{}: {}", path_, name); }

 private:
  template <class T>
  void exchange_number(std::string_view name, T& value) {
    std::vector<T> one{value};
    exchange(name, "", one);
    if (one.size() != 1) throw std::runtime_error(about(name) + " is not one number");
    value = one.front();
  }
  template <class T>
  void exchange(std::string_view name, std::string_view unit, std::vector<T>& values) {
    std::string const path(name);
    if (restoring()) {
      values.resize(count(path, type_of(T{})));
      restore(path, type_of(T{}), values.data(), values.size());
    } else {
      save(path, unit, type_of(T{}), values.data(), values.size());
    }
  }
  virtual void save(std::string const& name, std::string_view unit, hid_t type, void const* values,
                    std::size_t count) = 0;
  virtual std::size_t count(std::string const& name, hid_t type) = 0;
  virtual void restore(std::string const& name, hid_t type, void* values, std::size_t count) = 0;

  std::string path_;
};

class Writer final : public Hdf5Archive {
 public:
  Writer(std::string const& path, hid_t file) : Hdf5Archive(path), file_(file) {}
  bool restoring() const override { return false; }

 private:
  void save(std::string const& name, std::string_view unit, hid_t type, void const* values,
            std::size_t count) override {
    std::string const what = about(name) + " cannot be written";
    hsize_t const size = count;
    errno = 0;
    Handle const space(H5Screate_simple(1, &size, nullptr), H5Sclose, what);
    Handle const links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, what);
    expect_good(H5Pset_create_intermediate_group(links, 1), what);
    Handle data(H5Dcreate2(file_, name.c_str(), type, space, links, H5P_DEFAULT, H5P_DEFAULT),
                H5Dclose, what);
    if (count > 0) expect_good(H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), what);
    if (!unit.empty()) save_unit(data, unit, what);
    data.close(what);
  }
  std::size_t count(std::string const&, hid_t) override { return 0; }
  void restore(std::string const&, hid_t, void*, std::size_t) override {}

  static void save_unit(hid_t data, std::string_view unit, std::string const& what) {
    Handle const type(H5Tcopy(H5T_C_S1), H5Tclose, what);
    expect_good(H5Tset_size(type, unit.size()), what);
    Handle const space(H5Screate(H5S_SCALAR), H5Sclose, what);
    Handle const attribute(H5Acreate2(data, "unit", type, space, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose, what);
    expect_good(H5Awrite(attribute, type, std::string(unit).c_str()), what);
  }

  hid_t file_;
};

class Reader final : public Hdf5Archive {
 public:
  Reader(std::string const& path, hid_t file) : Hdf5Archive(path), file_(file) {}
  bool restoring() const override { return true; }

 private:
  void save(std::string const&, std::string_view, hid_t, void const*, std::size_t) override {}
  std::size_t count(std::string const& name, hid_t type) override {
    Handle const data(open(name));
    Handle const stored(H5Dget_type(data), H5Tclose, about(name));
    if (H5Tequal(stored, type) <= 0)
      throw std::runtime_error(about(name) + " has another type of numbers");
    Handle const space(H5Dget_space(data), H5Sclose, about(name));
    return static_cast<std::size_t>(expect_good(H5Sget_simple_extent_npoints(space), about(name)));
  }
  void restore(std::string const& name, hid_t type, void* values, std::size_t count) override {
    Handle const data(open(name));
    if (count > 0)
      expect_good(H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values),
                  about(name) + " cannot be read");
  }
  Handle open(std::string const& name) const {
    errno = 0;
    return {H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose, about(name) + " is missing"};
  }

  hid_t file_;
};

constexpr std::size_t image_growth = std::size_t{16} << 20;  // bytes at a time

/// Memory of a file image that HDF5 fills, and that stays when HDF5 closes the file.
class ImageMemory {
 public:
  ImageMemory() = default;
  ImageMemory(ImageMemory const&) = delete;
  ImageMemory& operator=(ImageMemory const&) = delete;
  ~ImageMemory() { std::free(memory_); }

  /// Makes files opened with these settings use this memory.
  herr_t serve(hid_t settings) {
    H5FD_file_image_callbacks_t callbacks{};
    callbacks.image_malloc = [](size_t size, H5FD_file_image_op_t, void* self) {
      return of(self).resize(size);
    };
    callbacks.image_memcpy = [](void* to, void const* from, size_t size, H5FD_file_image_op_t,
                                void*) { return std::memcpy(to, from, size); };
    callbacks.image_realloc = [](void*, size_t size, H5FD_file_image_op_t, void* self) {
      return of(self).resize(size);
    };
    callbacks.image_free = [](void*, H5FD_file_image_op_t, void*) -> herr_t { return 0; };
    callbacks.udata_copy = [](void* self) { return self; };
    callbacks.udata_free = [](void*) -> herr_t { return 0; };
    callbacks.udata = this;
    return H5Pset_file_image_callbacks(settings, &callbacks);
  }

  FileImage image(std::size_t size) const { return {static_cast<char*>(memory_), size}; }

 private:
  static ImageMemory& of(void* self) { return *static_cast<ImageMemory*>(self); }
  void* resize(std::size_t size) {
    void* const larger = std::realloc(memory_, size);
    if (larger != nullptr) memory_ = larger;
    return larger;
  }

  void* memory_ = nullptr;
};

/// HDF5 prints a stack of its own on every failure; ours say more to a user.
void keep_quiet() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

}  // namespace

void with_hdf5_image(Exchange const& exchange, std::function<void(FileImage)> const& use) {
  keep_quiet();
  std::string const what = "the checkpoint cannot be put together";
  errno = 0;
  ImageMemory memory;
  Handle const access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, what);
  expect_good(H5Pset_fapl_core(access, image_growth, false), what);
  expect_good(memory.serve(access), what);
  Handle const settings(H5Pcreate(H5P_FILE_CREATE), H5Pclose, what);
  expect_good(H5Pset_userblock(settings, seal_size), what);
  Handle file(H5Fcreate("image", H5F_ACC_TRUNC, settings, access), H5Fclose, what);
  Writer writer("checkpoint", file);
  exchange(writer);
  expect_good(H5Fflush(file, H5F_SCOPE_GLOBAL), what);
  // The used part of the memory, which grows in large pieces; HDF5 counts from behind the seal.
  auto const size =
      seal_size + static_cast<std::size_t>(expect_good(H5Fget_file_image(file, nullptr, 0), what));
  file.close(what);
  use(memory.image(size));
}

void restore_hdf5(std::filesystem::path const& path, Exchange const& exchange) {
  keep_quiet();
  std::string const what = path.string() + " is not a readable HDF5 file";
  errno = 0;
  Handle const file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, what);
  Reader reader(path.string(), file);
  exchange(reader);
}

}  // namespace moraine
