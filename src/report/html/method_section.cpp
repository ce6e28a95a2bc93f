#include "report/html/method_section.hpp"

#include <algorithm>
#include <vector>

#include "acquire/record/stated_date.hpp"
#include "core/error.hpp"
#include "report/html/page_elements.hpp"
#include "report/text/html_escape.hpp"

namespace percuss::report {
namespace {

constexpr std::size_t kMaxFiles = 200, kMaxDates = 3;

// The dates that the first files state, each once.
std::string dates_of(const std::vector<acquire::InputFile>& files) {
  std::vector<std::string> dates;
  for (std::size_t i = 0; i < std::min(files.size(), kMaxFiles); ++i) {
    const std::string date = acquire::date_of(files[i]);
    if (!date.empty() && std::find(dates.begin(), dates.end(), date) == dates.end()) dates.push_back(date);
  }
  if (dates.empty()) return "not found in the file";
  if (dates.size() > kMaxDates) return dates.front() + " to " + dates.back();
  std::string list;
  for (const std::string& date : dates) list += (list.empty() ? "" : "; ") + date;
  return list;
}

}  // namespace

std::string method_section(const pipeline::Analysis& analysis, const MethodScope& scope) {
  std::string sentences;
  for (const std::string& sentence : method_sentences(analysis, scope))
    sentences += (sentences.empty() ? "" : " ") + html_escape(one_line(sentence, 2000));
  return page_section("method", "Method",
                      "<p>" + sentences + "</p>\n" + channels_table(analysis).html() +
                          page_paragraph("Numbers in parentheses are equations of percuss's theory, docs/theory."));
}

TitleBlock with_file_facts(TitleBlock block, const pipeline::Analysis& analysis) {
  if (block.date.empty()) block.date = dates_of(analysis.record().files);
  return block;
}

}  // namespace percuss::report
