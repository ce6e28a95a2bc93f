#include "pipeline/live/row_store.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/io/read_at.hpp"

namespace percuss::pipeline {
namespace {

// For messages: "." does not tell the user which folder it is.
std::string absolute_folder(const std::string& folder) {
  std::error_code failed;
  const auto path = std::filesystem::canonical(folder, failed);
  return failed ? folder : path.string();
}

int open_unnamed(const std::string& folder) {
  const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file >= 0) return file;
  std::string name = folder + "/.percuss-rows-XXXXXX";  // a file system without O_TMPFILE
  const int named = ::mkostemp(name.data(), O_CLOEXEC);
  if (named < 0) {
    const int error = errno;
    throw_system_error("cannot keep rows", error, absolute_folder(folder), "write the record into another folder");
  }
  ::unlink(name.c_str());
  return named;
}

}  // namespace

RowStore::RowStore(const std::string& folder, std::size_t channels, std::size_t max_waiting_bytes)
    : file_(open_unnamed(folder)),
      folder_(absolute_folder(folder)),
      signals_(channels + 1),
      max_waiting_bytes_(max_waiting_bytes) {}

RowStore::~RowStore() { ::close(file_); }

void RowStore::append(const std::vector<std::vector<double>>& signals) {
  if (samples_ == 0) samples_ = signals.front().size();
  std::vector<double> row;
  row.reserve(signals_ * samples_);
  for (const std::vector<double>& signal : signals) row.insert(row.end(), signal.begin(), signal.end());
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(row));
    ++rows_;
  }
  write_waiting();
}

// The rows that wait are the last ones.
void RowStore::write_waiting() {
  for (;;) {
    const std::vector<double>* row = nullptr;  // stays in its place: this thread alone adds and removes rows
    std::size_t at = 0;
    {
      const std::lock_guard lock(mutex_);
      if (waiting_.empty()) return;
      row = &waiting_.front();
      at = rows_ - waiting_.size();
    }
    const int error = write_row(*row, at);
    const std::lock_guard lock(mutex_);
    if (error == 0) {
      waiting_.pop_front();
    } else if (waiting_.size() * signals_ * samples_ * sizeof(double) > max_waiting_bytes_) {
      throw_system_error("cannot keep a row", error, folder_, "free some room, and resume the session");
    } else {
      return;
    }
  }
}

int RowStore::write_row(const std::vector<double>& row, std::size_t number) const {
  auto at = static_cast<off_t>(number * row.size() * sizeof(double));
  const char* from = reinterpret_cast<const char*>(row.data());
  std::size_t left = row.size() * sizeof(double);
  while (left > 0) {
    const auto written = ::pwrite(file_, from, left, at);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return written < 0 ? errno : ENOSPC;
    from += written;
    at += written;
    left -= static_cast<std::size_t>(written);
  }
  return 0;
}

bool RowStore::read_waiting(std::size_t row, std::size_t first, std::span<double> out) const {
  const std::lock_guard lock(mutex_);
  const std::size_t written = rows_ - waiting_.size();
  if (row < written) return false;
  std::copy_n(waiting_.at(row - written).begin() + static_cast<std::ptrdiff_t>(first), out.size(), out.begin());
  return true;
}

void RowStore::read(std::size_t row, std::size_t signal, std::size_t first, std::span<double> out) const {
  if (read_waiting(row, signal * samples_ + first, out)) return;
  const std::uint64_t at = ((row * signals_ + signal) * samples_ + first) * sizeof(double);
  const ReadResult got = read_at(file_, at, out.data(), out.size_bytes());
  if (got.bytes < out.size_bytes())
    throw_system_error("cannot read a row again", got.error != 0 ? got.error : EIO, folder_, "check the disk");
}

void read_from(std::shared_ptr<const RowStore> store, std::vector<std::size_t> rows, acquire::Record& record) {
  record.read_force_N = [store, rows](std::size_t row, std::size_t first, std::span<double> out) {
    store->read(rows.at(row), 0, first, out);
  };
  record.read_accel_mps2 = [store = std::move(store), rows = std::move(rows)](
                               std::size_t row, std::size_t channel, std::size_t first, std::span<double> out) {
    store->read(rows.at(row), channel + 1, first, out);
  };
}

}  // namespace percuss::pipeline
