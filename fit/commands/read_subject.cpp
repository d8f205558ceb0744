#include "commands/read_subject.hpp"

#include <charconv>
#include <cmath>

#include "errors/input_error.hpp"
#include "math/units.hpp"
#include "surface/axes.hpp"

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
    if (!frame_) frame_ = {metres, Axes(read.axes)};
    return std::move(read.surface);
  }

  const FileFrame& frame() const { return *frame_; }

 private:
  const SurfaceOptions& options_;
  RegistrationSubject& subject_;
  std::optional<FileFrame> frame_;
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
  for (const std::string& text : request.landmarks)
    targets.landmarks.insert(landmark_of(text, files.frame()));
  return subject;
}

}  // namespace trunk
