/// @file
/// What to draw of a world between two steps.
#pragma once

#include <tumble/interpolation.hpp>
#include <tumble/world.hpp>

namespace tumble {

/// Where the models of a world's bodies are drawn, at any time between its last two steps: what
/// chapter 10's interpolation needs, kept by handle.
template <class Real>
class Drawing {
 public:
  /// Notes where all bodies are, at rest or not. To be called before the first step and after each.
  /// It visits every body: who draws few of very many keeps the poses of those itself, and
  /// interpolates them as pose() does, by interpolated().
  template <class Backend>
  void note(const World<Real, Backend>& world) {
    for (const BodyHandle handle : world.handles()) {
      Drawn& drawn = drawn_of(handle);
      const Pose<Real> now = pose_of(world.body(handle));
      drawn.before = drawn.is_noted ? drawn.now : now;
      drawn.now = now;
      drawn.is_noted = true;
    }
  }

  /// The body has a model whose axes are not the body's: `model_in_body` is what make_rigid_body()
  /// returns.
  void set_model(BodyHandle body, const Pose<Real>& model_in_body) {
    drawn_of(body).model_in_body = model_in_body;
  }

  /// The body is about to be put elsewhere: it is not drawn on the way there.
  void cut(BodyHandle body) { drawn_of(body).is_noted = false; }
  /// The same of all bodies, as before World::restore().
  void cut() {
    for (Drawn& drawn : drawn_) drawn.is_noted = false;
  }

  /// The pose of the model's axes in the world, at `fraction` (0 to 1, unchecked: beyond, it is led
  /// on) of the way from the step before the last to the last. Between, its centre of mass keeps to
  /// a straight line, as that of a free body does; its origin need not.
  /// @throws std::out_of_range if the body has not been noted.
  Pose<Real> pose(BodyHandle body, Same<Real> fraction) const {
    const Drawn& drawn = body.slot < drawn_.size() ? drawn_[body.slot] : Drawn();
    if (drawn.handle != body || !drawn.is_noted)
      throw std::out_of_range("body " + std::to_string(body.slot) + ", generation " +
                              std::to_string(body.generation) +
                              ", can't be drawn: note() has not seen it");
    return composed(interpolated(drawn.before, drawn.now, fraction), drawn.model_in_body);
  }

 private:
  struct Drawn {
    BodyHandle handle;
    Pose<Real> before = {}, now = {};  // of the body axes
    Pose<Real> model_in_body = {};
    bool is_noted = false;
  };

  /// A slot is used again when its body is gone; then all begins anew.
  Drawn& drawn_of(BodyHandle body) {
    if (body.slot >= drawn_.size()) drawn_.resize(body.slot + 1);
    Drawn& drawn = drawn_[body.slot];
    if (drawn.handle != body) drawn = {.handle = body};
    return drawn;
  }

  std::vector<Drawn> drawn_;  // by slot
};

}  // namespace tumble
