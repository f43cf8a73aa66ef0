/* fixcast diff: whether two pictures are equal, and where they differ most. */
#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include "commands.h"
#include "heat.h"
#include "image.h"
#include "raster_diff.h"
#include "report.h"
#include "scene_options.h"

namespace host {
namespace {

struct DiffOptions {
  std::string a, b, output;
  int zoom = 1;
  bool json = false;
};

std::string values_text(const Raster &raster, std::size_t pixel, const char *separator) {
  std::string text;
  for (const Channel &channel : raster.channels)
    text += (text.empty() ? "" : separator) + channel.name + " " + number_text(channel.samples[pixel]);
  return text;
}

std::string words(const DiffOptions &options, const Raster &a, const Raster &b, const RasterDifference &d) {
  if (!d.mismatch.empty()) return d.mismatch + "\n";
  if (d.same()) return "same\n";
  const std::size_t worst = static_cast<std::size_t>(d.worst_y) * static_cast<std::size_t>(a.width) + static_cast<std::size_t>(d.worst_x);
  return count_text(d.pixels, "pixel") + " of " + std::to_string(a.pixels()) + " differ; worst at " + std::to_string(d.worst_x) + " " +
         std::to_string(d.worst_y) + ": channel " + a.channels[d.worst_channel].name + " by " + number_text(d.worst) + "\n" + options.a +
         ": " + values_text(a, worst, ", ") + "\n" + options.b + ": " + values_text(b, worst, ", ") + "\n";
}

/* JSON has no infinity. */
std::string json_number(double value) {
  const std::string text = number_text(value);
  return text.find_first_of("in") == std::string::npos ? text : "\"" + text + "\"";
}

std::string json_values(const Raster &raster, std::size_t pixel) {
  std::string text;
  for (const Channel &channel : raster.channels) text += (text.empty() ? "" : ", ") + json_number(channel.samples[pixel]);
  return "[" + text + "]";
}

std::string json_text(const Raster &a, const Raster &b, const RasterDifference &d) {
  std::string text = std::string("{\"same\": ") + (d.same() ? "true" : "false");
  if (!d.mismatch.empty()) text += ", \"mismatch\": \"" + d.mismatch + "\"";
  if (d.mismatch.empty()) text += ", \"pixels\": " + std::to_string(d.pixels);
  if (d.pixels > 0) {
    const std::size_t worst = static_cast<std::size_t>(d.worst_y) * static_cast<std::size_t>(a.width) + static_cast<std::size_t>(d.worst_x);
    text += ", \"x\": " + std::to_string(d.worst_x) + ", \"y\": " + std::to_string(d.worst_y) + ", \"channel\": \"" +
            a.channels[d.worst_channel].name + "\", \"a\": " + json_values(a, worst) + ", \"b\": " + json_values(b, worst);
  }
  return text + "}\n";
}

int run_diff(const DiffOptions &options) {
  for (const std::string &input : {options.a, options.b})
    if (!options.output.empty()) check_not_same_file(input, options.output);
  const Raster a = read_raster(options.a), b = read_raster(options.b);
  const RasterDifference d = difference(a, b);
  std::string text = options.json ? json_text(a, b, d) : words(options, a, b, d);
  if (!options.output.empty()) {
    std::vector<Image8> pictures = {zoomed(picture_of(a), options.zoom), zoomed(picture_of(b), options.zoom)};
    if (d.mismatch.empty()) pictures.push_back(zoomed(heat_map(a.width, a.height, d.levels), options.zoom));
    const std::string written = write_image(options.output, side_by_side(pictures));
    if (!options.json) text += "wrote " + written + ": " + options.a + ", " + options.b + (d.mismatch.empty() ? ", difference\n" : "\n");
  }
  (void)std::fputs(text.c_str(), stdout);
  return d.same() ? 0 : 1;
}

} // namespace

void add_diff_command(CLI::App &app, Action &action) {
  const auto options = std::make_shared<DiffOptions>();
  CLI::App *command = app.add_subcommand("diff", "Tell whether two pictures are equal: exit code 0 equal, 1 not, 2 unreadable");
  command->add_option("a", options->a, "a picture")->required()->type_name("A");
  command->add_option("b", options->b, "another of the same size, channels and sample format")->required()->type_name("B");
  command->add_option("-o,--output", options->output, "write both and a heat map of their difference side by side")->type_name("DIFF.png");
  command->add_option("--zoom", options->zoom, "pixels of that picture a pixel; default 1")->check(CLI::Range(1, 16))->type_name("N");
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([&action, options] { action = [options] { return run_diff(*options); }; });
}

} // namespace host
