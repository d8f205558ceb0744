#include "commands/read_subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "errors/input_error.hpp"
#include "math/units.hpp"
#include "surface/axes.hpp"
#include "surface/orientation.hpp"

namespace trunk {
namespace {

/// From the coordinates of the surface files to the trunk's unit and axes.
struct FileFrame {
  double metres = 1.0;
  Axes axes;
};

/// Returns the name and the point that "name=x,y,z" gives, in the coordinates of the files.
std::pair<std::string, Vec3d> landmark_of(const std::string& text, const FileFrame& frame) {
  const auto fail = [&]() -> InputError {
    return {Place{"--landmark " + text}, "is not a landmark",
            "name=x,y,z in the coordinates of the surface files"};
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) throw fail();
  double at[3];
  const char *next = text.data() + equals + 1, *end = text.data() + text.size();
  for (int k = 0; k < 3; ++k) {
    const auto [stop, error] = std::from_chars(next, end, at[k]);
    const bool last = k == 2;
    if (error != std::errc{} || !std::isfinite(at[k]) || (last ? stop != end : stop == end || *stop != ','))
      throw fail();
    next = stop + 1;
  }
  return {text.substr(0, equals), frame.axes(frame.metres * Vec3d{at[0], at[1], at[2]})};
}

/// Reads one surface after the other and keeps the frame of the first.
class SurfaceFiles {
 public:
  SurfaceFiles(const SurfaceOptions& options, RegistrationSubject& subject)
      : options_(options), subject_(subject) {}

  MeasuredSurface read(const std::string& file) {
    SurfaceOptions options = options_;
    if (frame_) options.axes_of_others = frame_->axes.letters();
    ImportedSurface read = read_surface(file, options);
    for (const std::string& note : read.notes) subject_.notes.push_back(file + ": " + note);
    subject_.files.push_back(file);
    const double metres = read.unit == "m" ? 1.0 : read.unit == "cm" ? 1e-2 : m_per_mm;
    if (!frame_) {
      frame_ = {metres, Axes(read.axes)};
      assumed_ = read.axes_assumed;
    }
    return std::move(read.surface);
  }

  const FileFrame& frame() const { return *frame_; }

  /// Doubts axes with which the skin is deeper than wide.
  void look_at_skin() {
    const auto& skin = subject_.measurements.skin;
    if (!skin) return;
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (const Vec3d& p : skin->points) {
      low[0] = std::min(low[0], p.x());
      high[0] = std::max(high[0], p.x());
      low[1] = std::min(low[1], p.y());
      high[1] = std::max(high[1], p.y());
    }
    if (high[0] - low[0] < high[1] - low[1])
      note_first(
          "the axes are in doubt: with them (x right, y forward, z up) the skin is deeper than wide; check "
          "--axes");
  }

  /// Takes the axes that two lungs show, where they were assumed, and doubts others.
  void look_at_lungs() {
    SubjectMeasurements& targets = subject_.measurements;
    if (targets.lungs.empty()) return;
    const auto guess = guess_axes_of_lungs(joined(targets.lungs));
    const std::string letters = guess ? guess->axes.letters() : "RAS";
    if (assumed_ && guess) {
      std::erase_if(subject_.notes,
                    [](const std::string& note) { return note.find(": axes ") != std::string::npos; });
      note_first(fmt::format("axes guessed as {}, since the files do not say them: {}; --axes overrides this",
                             letters, guess->reasons));
      for (MeasuredSurface& lung : targets.lungs) turn(lung, guess->axes);
      for (auto* surface : {&targets.diaphragm, &targets.skin, &targets.ribs})
        if (*surface) turn(**surface, guess->axes);
      frame_->axes = guess->axes;
    } else if (letters != "RAS") {
      note_first(fmt::format("the axes are in doubt: with them (x right, y forward, z up) {}; check --axes",
                             guess->reasons));
    }
  }

 private:
  void note_first(const std::string& note) { subject_.notes.insert(subject_.notes.begin(), note); }

  static void turn(MeasuredSurface& surface, const Axes& axes) {
    for (Vec3d& p : surface.points) p = axes(p);
    face_outward(surface);
  }

  const SurfaceOptions& options_;
  RegistrationSubject& subject_;
  std::optional<FileFrame> frame_;
  bool assumed_ = false;
};

}  // namespace

RegistrationSubject read_subject(const RegisterRequest& request) {
  RegistrationSubject subject;
  SubjectMeasurements& targets = subject.measurements;
  SurfaceFiles files(request.file, subject);
  if (!request.surface.empty()) targets.diaphragm = files.read(request.surface);
  for (const std::string& file : request.lungs) targets.lungs.push_back(files.read(file));
  if (!request.skin.empty()) targets.skin = files.read(request.skin);
  if (!request.ribs.empty()) targets.ribs = files.read(request.ribs);
  if (subject.files.empty())
    throw InputError(Place{}, "no surface is given", "--surface, --lungs, --skin or --ribs FILE");
  files.look_at_lungs();
  files.look_at_skin();
  for (const std::string& text : request.landmarks)
    targets.landmarks.insert(landmark_of(text, files.frame()));
  return subject;
}

}  // namespace trunk
