#pragma once
#include <span>
#include <string_view>

namespace percuss::report {

/// The style sheet and the scripts of every page (html/page), and of uPlot (third_party/uplot).
struct PageAssets {
  std::string_view style;
  std::span<const std::string_view> program;  ///< the scripts of html/page, to be written one after another
  std::string_view plot_style, plot_program;
};
const PageAssets& page_assets();

}  // namespace percuss::report
