#include "metrics/study/study_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace percuss::metrics {
namespace {

using enum StudyQuantity;

constexpr int kAppendixB = -1;  // first_by_length of figures B1 to B5, for 30 to 34 in

// A group of figures of the source, y over x. first_by_length is the number of its figure for 31 in (the figures for 32
// to 34 in follow). of_all is the number of its figure for all lengths. 0: the source has none.
struct FigureKind {
  StudyFamily family;
  StudyQuantity x, y;
  int first_by_length, of_all;
};
constexpr std::array<FigureKind, 18> kKinds{{{StudyFamily::wood, moi, besr, 0, 13},
                                             {StudyFamily::wood, moi, bbs, 0, 14},
                                             {StudyFamily::wood, moi, bbcor, 0, 15},
                                             {StudyFamily::wood, drop, besr, kAppendixB, 16},
                                             {StudyFamily::wood, drop, bbs, 0, 17},
                                             {StudyFamily::wood, drop, bbcor, 0, 18},
                                             {StudyFamily::wood, bending1, besr, 0, 19},
                                             {StudyFamily::wood, bending1, bbs, 0, 20},
                                             {StudyFamily::wood, bending1, bbcor, 0, 21},
                                             {StudyFamily::nonwood, moi, besr, 22, 26},
                                             {StudyFamily::nonwood, moi, bbs, 27, 31},
                                             {StudyFamily::nonwood, moi, bbcor, 32, 36},
                                             {StudyFamily::nonwood, bending1, besr, 37, 41},
                                             {StudyFamily::nonwood, bending1, bbs, 42, 46},
                                             {StudyFamily::nonwood, bending1, bbcor, 47, 51},
                                             {StudyFamily::nonwood, hoop1, besr, 55, 0},
                                             {StudyFamily::nonwood, hoop1, bbs, 59, 0},
                                             {StudyFamily::nonwood, hoop1, bbcor, 63, 0}}};

const char* family_words(StudyFamily family) { return family == StudyFamily::wood ? "wood" : "nonwood"; }

std::string short_name(StudyQuantity q) {
  const std::string column = column_of(q);
  return column.substr(0, column.find('_'));
}

std::string source_figure(const FigureKind& kind, int length) {
  if (length == 0) return kind.of_all == 0 ? "" : std::to_string(kind.of_all);
  if (kind.first_by_length == kAppendixB) return length >= 30 && length <= 34 ? fmt::format("B{}", length - 29) : "";
  if (kind.first_by_length == 0 || length < 31 || length > 34) return "";
  return std::to_string(kind.first_by_length + length - 31);
}

using ByLength = std::map<int, std::vector<std::size_t>>;

ByLength bats_by_length(const std::vector<StudyBat>& bats, const FigureKind& kind) {
  ByLength out;
  for (std::size_t b = 0; b < bats.size(); ++b) {
    const bool wood = bats[b].material == BarrelMaterial::wood;
    if (wood == (kind.family == StudyFamily::wood) && bats[b].value(kind.x) && bats[b].value(kind.y))
      out[bats[b].length_class()].push_back(b);
  }
  return out;
}

StudyFigure figure_of(const FigureKind& kind, int length) {
  std::string axis_x = phrase_of(kind.x);
  if (axis_x.starts_with("the ")) axis_x = axis_x.substr(4);
  std::string y = phrase_of(kind.y);
  y.front() = y == "batted-ball speed" ? 'B' : y.front();
  return {.name = fmt::format("{}-{}-{}-{}", short_name(kind.y), short_name(kind.x), family_words(kind.family),
                              length == 0 ? "all" : std::to_string(length)),
          .title = fmt::format("{} vs. {}, {}{} bats", y, axis_x, length == 0 ? "" : fmt::format("{}-in. ", length),
                               family_words(kind.family)),
          .source = source_figure(kind, length),
          .x = kind.x,
          .y = kind.y,
          .family = kind.family,
          .length_class = length};
}

}  // namespace

std::vector<StudyFigure> study_figures_of(const std::vector<StudyBat>& bats) {
  std::vector<StudyFigure> out;
  for (const FigureKind& kind : kKinds) {
    const ByLength lengths = bats_by_length(bats, kind);
    if (lengths.empty()) continue;
    StudyFigure all = figure_of(kind, 0);
    StudyClass all_lengths;
    for (const auto& [length, members] : lengths) {
      StudyClass one{.length_class = length, .bats = members};
      all_lengths.bats.insert(all_lengths.bats.end(), members.begin(), members.end());
      if (kind.first_by_length != 0) {
        out.push_back(figure_of(kind, length));
        out.back().classes = {one};
      }
      all.classes.push_back(std::move(one));
    }
    all.classes.push_back(std::move(all_lengths));
    out.push_back(std::move(all));
  }
  return out;
}

std::vector<StudyStatement> published_statements() {
  struct PublishedStatement {
    StudyFamily family;
    StudyQuantity y, x;
    int sign;
  };
  using enum StudyFamily;
  constexpr std::array<PublishedStatement, 18> claims{{{wood, besr, moi, 1},
                                                       {wood, bbs, moi, 1},
                                                       {wood, bbcor, moi, 0},
                                                       {wood, besr, drop, 1},
                                                       {wood, bbs, drop, -1},
                                                       {wood, bbcor, drop, 0},
                                                       {wood, besr, bending1, 1},
                                                       {wood, bbs, bending1, 1},
                                                       {wood, bbcor, bending1, 1},
                                                       {nonwood, besr, moi, 1},
                                                       {nonwood, bbs, moi, -1},
                                                       {nonwood, bbcor, moi, -1},
                                                       {nonwood, besr, bending1, 1},
                                                       {nonwood, bbs, bending1, 1},
                                                       {nonwood, bbcor, bending1, 0},
                                                       {nonwood, besr, hoop1, -1},
                                                       {nonwood, bbs, hoop1, -1},
                                                       {nonwood, bbcor, hoop1, -1}}};
  std::vector<StudyStatement> out;
  for (const PublishedStatement& c : claims) {
    const std::string who = fmt::format("{} of {} bats", phrase_of(c.y), family_words(c.family));
    out.push_back({.text = c.sign > 0   ? fmt::format("{} rises with {}", who, phrase_of(c.x))
                           : c.sign < 0 ? fmt::format("{} rises as {} falls", who, phrase_of(c.x))
                                        : fmt::format("{} does not depend on {}", who, phrase_of(c.x)),
                   .x = c.x,
                   .y = c.y,
                   .family = c.family,
                   .sign = c.sign});
  }
  return out;
}

}  // namespace percuss::metrics
