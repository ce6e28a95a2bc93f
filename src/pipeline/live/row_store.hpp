#pragma once
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::pipeline {

/// Rows of equal length in an unlinked file, so that memory does not grow with the session and a kill leaves no file
/// behind. The journal, not this file, protects the samples against loss. While the disk is full, rows wait in memory.
class RowStore {
 public:
  static constexpr std::size_t kMaxWaiting_bytes = std::size_t{64} << 20U;

  /// `folder` has room for the session. errors  InputError: no file can be made there.
  RowStore(const std::string& folder, std::size_t channels, std::size_t max_waiting_bytes = kMaxWaiting_bytes);
  ~RowStore();
  RowStore(const RowStore&) = delete;
  RowStore& operator=(const RowStore&) = delete;

  /// Appends a row: force and responses, [1 + channels][samples], in SI units. The first row sets the length.
  /// errors  InputError: the disk is full, and more than max_waiting_bytes wait for room.
  void append(const std::vector<std::vector<double>>& signals);
  std::size_t samples() const { return samples_; }
  /// Reads samples first … first + out.size() − 1 of a signal; signal 0 is the force. Several threads may call at once,
  /// also during append(). errors  InputError: the file cannot be read.
  void read(std::size_t row, std::size_t signal, std::size_t first, std::span<double> out) const;

 private:
  void write_waiting();
  int write_row(const std::vector<double>& row, std::size_t number) const;  // 0, or errno
  bool read_waiting(std::size_t row, std::size_t first, std::span<double> out) const;

  int file_ = -1;
  std::string folder_;
  std::size_t signals_, samples_ = 0, max_waiting_bytes_;
  mutable std::mutex mutex_;                 // guards the members below
  std::size_t rows_ = 0;                     // written and waiting
  std::deque<std::vector<double>> waiting_;  // each [signals × samples]
};

/// Gives `record` the rows `rows` of the store as its samples. Its row descriptions are left as they are.
void read_from(std::shared_ptr<const RowStore> store, std::vector<std::size_t> rows, acquire::Record& record);

}  // namespace percuss::pipeline
