#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace percuss::tools {

/// Options that are wrong, as data; each interface writes them in its own words.
///   throw OptionError({"from", "to"}, "exclude each other", "give one of them")
/// The command line prints "--from and --to exclude each other; give one of them", Python "from_= and to= exclude …".
class OptionError : public UsageError {
 public:
  /// `problem` is a predicate, "exclude each other", and the options are its subject. `remedy_options` follow the
  /// remedy in parentheses, as Message::written() lists them.
  OptionError(std::vector<OptionId> options, std::string_view problem, std::string_view remedy,
              std::vector<OptionId> remedy_options = {});
  /// "--band cannot be '9': the reason; the remedy".
  static OptionError wrong_value(const OptionId& option, std::string_view value, std::string_view remedy,
                                 std::string_view reason = {}, std::vector<OptionId> remedy_options = {});

  const std::vector<OptionId>& options() const { return options_; }
  const std::vector<OptionId>& remedy_options() const { return remedy_options_; }
  const std::string& problem() const { return problem_; }
  const std::string& remedy() const { return remedy_; }
  /// The rejected value; empty if the error is about several options, or about no value.
  const std::string& value() const { return value_; }
  /// The message with the options as the interface writes them.
  std::string written(OptionWriter write) const;

 private:
  std::vector<OptionId> options_, remedy_options_;
  std::string problem_, remedy_, value_;
};

}  // namespace percuss::tools
