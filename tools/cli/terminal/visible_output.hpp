#pragma once
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>

namespace percuss::tools {

/// Replaces hidden characters in the output of a stream by escapes (core/visible_text.hpp) during its lifetime, so that
/// names and texts from files cannot command the terminal.
///   const VisibleOutput output(std::cout);
class VisibleOutput : private std::streambuf {
 public:
  explicit VisibleOutput(std::ostream& stream);
  ~VisibleOutput() override;
  VisibleOutput(const VisibleOutput&) = delete;
  VisibleOutput& operator=(const VisibleOutput&) = delete;

 private:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override;
  int_type overflow(int_type character) override;
  int sync() override;
  bool copy(std::string_view text);
  bool show(std::string_view text);

  std::ostream& stream_;
  std::streambuf* const to_;
  std::string begun_;  // the first bytes of a character that is not complete yet
};

}  // namespace percuss::tools
