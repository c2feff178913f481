#include <array>
#include <exercise/judge.hpp>
#include <tumble/mass_properties.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

/// m kg of handle, l m long, and M kg of head.
template <class Real>
struct Hammer {
  Real m, l, M;
};

template <class Real>
Hammer<Real> usual_hammer() {
  return {Real(0.25), Real(0.5), Real(parameter("head_mass"))};
}

/// At half a metre a length halved is a length squared, so another is asked for too.
template <class Real>
std::array<Hammer<Real>, 2> two_hammers() {
  auto longer = usual_hammer<Real>();
  longer.l = Real(0.8);
  return {usual_hammer<Real>(), longer};
}

template <class Real>
Real about_grip(const Hammer<Real>& h) {
  return ask<Real>("moment_about_grip", h.m, h.l, h.M);
}

template <class Real>
MassProperties<Real> whole(const Hammer<Real>& h) {
  return ask<MassProperties<Real>>("hammer", h.m, h.l, h.M);
}

template <class Real>
constexpr double few_roundings = 16 * unit_roundoff<Real>;

}  // namespace

EXERCISE_CHECK(
    "The centre of mass lies between the middle of the handle and the head, nearer the heavier") {
  for (const auto& [m, l, M] : two_hammers<Real>()) {
    const Real truth = (m * l / 2 + M * l) / (m + M);
    Found("the height of the centre of mass of a hammer with a head of " + shown(M) + " kg, " +
              shown(l) + " m long,",
          "m", ask<Real>("height_of_centre", m, l, M))
        .mistake(l * 3 / 4,
                 "that is halfway between the parts, as if they were equally heavy. Weigh each by "
                 "its mass")
        .mistake(l / 2, "that is the middle of the handle. Where is the head?")
        .mistake(m * l / 2 + M * l,
                 "the sum of mass times place is there; divide it by the mass of the hammer")
        .mistake((m * l + M * l / 2) / (m + M),
                 "the weights are exchanged: it lies nearer the lighter part")
        .mistake((m * l + M * l) / (m + M),
                 "the handle counts as if it sat at its upper end; its own centre is at l/2")
        .must_be(truth, few_roundings<Real>);
  }
}

EXERCISE_CHECK("A handle alone has a third of m l² about its end") {
  const Real m = Real(0.75);
  for (const Real l : {Real(0.5), Real(1.25)})
    Found("the moment of a handle of 0.75 kg and " + shown(l) + " m about its end", "kg m²",
          about_grip<Real>({m, l, 0}))
        .mistake(m * l * l / 12, "that is m l²/12, about the handle's middle")
        .mistake(m * l * l, "that is m l², as if all of the handle were at its upper end")
        .mistake(m * l * l / 4,
                 "that is m (l/2)², the handle as one particle. It also turns about its own middle")
        .mistake(m * l / 3, "the length counts with its square")
        .must_be(m * l * l / 3, few_roundings<Real>);
}

EXERCISE_CHECK("Twice the head adds twice as much to the moment about the grip") {
  for (const Hammer<Real>& light : two_hammers<Real>()) {
    auto none = light, heavy = light;
    none.M = 0;
    heavy.M = 2 * light.M;
    const Real handle = about_grip(none);
    const Real once = about_grip(light) - handle, twice = about_grip(heavy) - handle;
    require(once > 0, "a head of " + shown(light.M) + " kg adds " + shown(once) +
                          " kg m² to the moment; it must add more than nothing");
    Found("with a head twice as heavy, the head's share grew by a factor that", "", twice / once)
        .mistake(4,
                 "the head is twice as heavy, so its share should double; yours grew fourfold. Is "
                 "a mass "
                 "squared?")
        .mistake(
            1,
            "the head is twice as heavy, so its share should double; yours stayed. Is its mass "
            "missing?")
        .must_be(2, 8 * few_roundings<Real>);
    Found("the share of a head of " + shown(light.M) + " kg at " + shown(light.l) + " m", "kg m²",
          once)
        .mistake(light.M * light.l, "the distance counts with its square")
        .must_be(light.M * light.l * light.l, 4 * few_roundings<Real>);
  }
}

EXERCISE_CHECK("About the centre of mass it is what a thousand particles give") {
  for (const Hammer<Real>& h : two_hammers<Real>()) {
    const auto body = whole(h);
    const double m = h.m, l = h.l, M = h.M, c = (m * l / 2 + M * l) / (m + M);
    // A thousand slices of the handle, each as one particle in its middle, and the head. What the
    // slices lack of the handle is their own inertia about their middles, 1e-6 of it.
    std::vector<Particle<double>> particles{make_particle(M, Vec3d(0, 0, l))};
    const int slices = 1000;
    for (int i = 0; i < slices; ++i)
      particles.push_back(make_particle(m / slices, Vec3d(0, 0, l * (i + 0.5) / slices)));
    const MassPropertiesd truth = mass_properties(particles);
    const double own = m * l * l / 12 / slices / slices;

    Found("the mass", "kg", body.mass).must_be(h.m + h.M, few_roundings<Real>);
    Found("the centre of mass", "m", body.centre_of_mass)
        .mistake(Vec3<Real>::Zero(), "that is the end of the grip")
        .must_be(truth.centre_of_mass.template cast<Real>(), 1e-12 + few_roundings<Real>);
    const double about_grip = m * l * l / 3 + M * l * l, shift = (m + M) * c * c;
    Found("the moment about x through the centre of mass", "kg m²", body.inertia(0, 0))
        .mistake(
            Real(about_grip),
            "that is the one about the end of the grip. The parallel axis through the centre of "
            "mass is easier")
        .mistake(Real(about_grip + shift),
                 "it is larger than about the grip. Towards the centre of mass, M d² is taken away")
        .mistake(
            Real(m * l * l / 12),
            "that is the handle's own. The centre of mass is not in its middle, and the head is "
            "missing")
        .mistake(Real(m * l * l / 12 + M * (l - c) * (l - c)),
                 "the handle's middle is not the centre of mass: shift the handle too")
        .mistake(Real(m * l * l / 12 + m * (c - l / 2) * (c - l / 2)), "the head is missing")
        .must_be(Real(truth.inertia(0, 0) + own), 8 * few_roundings<Real> * about_grip + 1e-12);
  }
}

EXERCISE_CHECK(
    "The tensor is that of a thing turned on a lathe: equal about x and y, nothing about z, no "
    "products") {
  const auto I = whole(usual_hammer<Real>()).inertia;
  require(I(0, 0) > 0,
          "the moment about x is " + shown(I(0, 0)) + " kg m²; it must be greater than 0");
  Found("the moment about y", "kg m²", I(1, 1))
      .mistake(0, "a thin hammer is as hard to turn about y as about x")
      .must_be(I(0, 0), 0);
  Found("the moment about z", "kg m²", I(2, 2))
      .mistake(I(0, 0), "all mass is on the z axis, so nothing resists a turn about it")
      .must_be(0, 0);
  Mat3<Real> products = I;
  products.diagonal().setZero();
  Found("the tensor without its diagonal", "kg m²", products).must_be(Mat3<Real>::Zero(), 0);
}
