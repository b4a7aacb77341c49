// SPDX-License-Identifier: Apache-2.0
#include "cli/simulate_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/frame_statistics.hpp"
#include "cli/interrupt.hpp"
#include "io/feature_files.hpp"
#include "io/views.hpp"
#include "sim/simulator.hpp"

namespace trihedron::cli {
namespace {

/// Where a frame in the pipeline comes from, to name its results when they arrive.
struct Ticket {
  std::string sequence;
  int id = 0;
  int number = 0;  ///< of the frames started
};

/// One simulation of many frames: deals them out to the views and takes the features in.
class Job {
 public:
  Job(const SimulateArguments& arguments, FrameInputs& inputs,
      const std::function<void(const std::string&)>& print)
      : arguments_(arguments), inputs_(inputs), print_(print), statistics_(arguments.stats) {}

  SimulationOutcome run() {
    if (arguments_.front_end == "rtl")
      simulate();
    else
      compute();
    return outcome_;
  }

 private:
  void simulate() {
    sim::RunOptions options;
    options.seed = arguments_.seed;
    options.check = arguments_.check;
    options.trace_file = arguments_.trace;
    if (arguments_.spoil) {
      options.expected_thresholds = golden::FrontEndConfig{};
      options.expected_thresholds->first_contour.noise_floor = 511;
    }
    options.pixel_idles = {arguments_.idles, 8};
    options.contour_stalls = options.vertex_stalls = {arguments_.stalls, 8};
    const sim::Report report = sim::Simulator::instance().run(
        options, [this](int view) { return next_for(view); },
        [this](sim::FrameResult&& frame) {
          const auto view = static_cast<std::size_t>(frame.view);
          const Ticket ticket = std::move(in_flight_[view].front());
          in_flight_[view].pop_front();
          finish(ticket, frame);
        });
    take(report);
  }

  void compute() {
    while (std::optional<InputFrame> frame = next()) {
      sim::FrameResult result;
      result.features = golden_front_end()({frame->grey}).front();
      finish({frame->sequence, frame->id, started_ - 1}, result);
    }
  }

  void take(const sim::Report& report) {
    outcome_.clocks = report.clocks;
    outcome_.compared = report.compared;
    outcome_.passed = report.passed();
    if (report.mismatch) outcome_.mismatch = place_of(*report.mismatch) + report.mismatch->text();
    for (const sim::ViewStatistics& view : report.views) {
      outcome_.pixels += view.pixels;
      outcome_.input_stalls += view.input_stalls;
      outcome_.input_idles += view.input_idles;
      outcome_.latency_clocks = std::max(outcome_.latency_clocks, view.latency_clocks);
    }
  }

  /// The input of a difference: the view's frame that has not come out whole, if there is one.
  std::string place_of(const sim::Mismatch& mismatch) const {
    const auto& waiting = in_flight_[static_cast<std::size_t>(mismatch.view)];
    if (waiting.empty()) return "";
    return fmt::format("{}/{:06}: ", waiting.front().sequence, waiting.front().id);
  }

  std::optional<InputFrame> next() {
    if (arguments_.limit > 0 && started_ == arguments_.limit) return std::nullopt;
    if (Interruption::requested()) return std::nullopt;  // what is in the pipeline still comes out
    std::optional<InputFrame> frame = inputs_.next();
    started_ += frame.has_value();
    return frame;
  }

  /// The images of a scene go to their own views, all others to whichever view is free.
  std::optional<sim::SourceFrame> next_for(int view) {
    auto& waiting = waiting_[static_cast<std::size_t>(view)];
    while (waiting.empty()) {
      std::optional<InputFrame> frame = next();
      if (!frame) return std::nullopt;
      const int home = frame->view < 0 ? view : frame->view;
      waiting_[static_cast<std::size_t>(home)].emplace_back(std::move(*frame), started_ - 1);
    }
    const auto [frame, number] = std::move(waiting.front());
    waiting.pop_front();
    in_flight_[static_cast<std::size_t>(view)].push_back({frame.sequence, frame.id, number});
    return sim::SourceFrame{to_grey_image(frame.grey)};
  }

  void finish(const Ticket& ticket, const sim::FrameResult& frame) {
    const ViewFeatures& features = frame.features;
    if (!arguments_.out.empty())
      write_features(std::filesystem::path(arguments_.out) / ticket.sequence, ticket.id, features);
    const auto contour = static_cast<std::uint64_t>(
        std::count_if(features.contour.begin(), features.contour.end(),
                      [](const ContourBeat& beat) { return beat.contour(); }));
    ++outcome_.frames;
    outcome_.contour_px += contour;
    outcome_.vertices += features.vertices.size();
    statistics_.add(ticket.sequence, ticket.id, frame, contour);
    done_[ticket.number] = fmt::format(
        "{}/{:06} {}x{} px: {} contour px, {} vertices, {} lost{}", ticket.sequence, ticket.id,
        features.width, features.height, contour, features.vertices.size(), features.vertices_lost,
        frame.clocks > 0
            ? fmt::format(", {} clocks, latency {}", frame.clocks, frame.latency_clocks)
            : "");
    for (auto first = done_.begin(); first != done_.end() && first->first == printed_;
         first = done_.erase(first), ++printed_)
      print_(first->second);
  }

  const SimulateArguments& arguments_;
  FrameInputs& inputs_;
  const std::function<void(const std::string&)>& print_;
  FrameStatistics statistics_;
  std::array<std::deque<std::pair<InputFrame, int>>, sim::kViews> waiting_;
  std::array<std::deque<Ticket>, sim::kViews> in_flight_;
  std::map<int, std::string> done_;  ///< lines of frames that came out before their turn
  int started_ = 0, printed_ = 0;
  SimulationOutcome outcome_;
};

}  // namespace

void SimulationOutcome::add(const SimulationOutcome& part) {
  frames += part.frames;
  contour_px += part.contour_px;
  vertices += part.vertices;
  clocks += part.clocks;
  pixels += part.pixels;
  input_stalls += part.input_stalls;
  input_idles += part.input_idles;
  latency_clocks = std::max(latency_clocks, part.latency_clocks);
  compared.frames += part.compared.frames;
  compared.beats += part.compared.beats;
  compared.records += part.compared.records;
  compared.registers += part.compared.registers;
  passed = passed && part.passed;
  if (mismatch.empty()) mismatch = part.mismatch;
}

std::string SimulationOutcome::to_text() const {
  return nlohmann::json{frames,          contour_px,     vertices,         clocks,
                        pixels,          input_stalls,   input_idles,      latency_clocks,
                        compared.frames, compared.beats, compared.records, compared.registers,
                        passed,          mismatch}
      .dump();
}

SimulationOutcome SimulationOutcome::from_text(const std::string& text) {
  const nlohmann::json o = nlohmann::json::parse(text);
  return {o[0], o[1], o[2], o[3], o[4], o[5], o[6], o[7], {o[8], o[9], o[10], o[11]}, o[12], o[13]};
}

SimulationOutcome simulate_frames(const SimulateArguments& arguments, FrameInputs& inputs,
                                  const std::function<void(const std::string&)>& print) {
  return Job(arguments, inputs, print).run();
}

}  // namespace trihedron::cli
