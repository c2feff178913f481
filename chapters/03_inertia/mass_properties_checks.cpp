// Other points, other axes, other places, several parts.
#include <support/checks.hpp>
#include <support/particle_cloud.hpp>
#include <tumble/principal_axes.hpp>
#include <tumble/spheres.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A lump without any symmetry.
template <class Real>
std::vector<Particle<Real>> lump(unsigned seed) {
  RandomGenerator dice(seed);
  std::vector<Particle<Real>> particles;
  for (int i = 0; i < 20; ++i)
    particles.push_back(make_particle(Real(0.5 + dice()), dice.vector<Real>()));
  return particles;
}

}  // namespace

TEST_CASE_TEMPLATE("The parallel axis theorem gives what the particles give about that point", Real,
                   EVERY_PRECISION) {
  const std::vector<Particle<Real>> particles = lump<Real>(5);
  const MassProperties<Real> body = mass_properties(particles);
  for (const Vec3<Real>& point :
       {Vec3<Real>(0, 0, 0), Vec3<Real>(1, -2, Real(0.3)), Vec3<Real>(-40, 7, 11)}) {
    Mat3<Real> directly = Mat3<Real>::Zero();
    for (const Particle<Real>& particle : particles)
      directly += inertia_of_particle<Real>(mass_of(particle), particle.position - point);
    // 20 terms of positive trace: each rounds some 8 times, the sum 20 times, the theorem 16.
    CHECK((inertia_about(body, point) - directly).norm() <=
          48 * unit_roundoff<Real> * directly.trace());
  }
}

TEST_CASE_TEMPLATE("There and back by the parallel axis is no journey", Real, EVERY_PRECISION) {
  const MassProperties<Real> body = mass_properties(lump<Real>(6));
  const Vec3<Real> point(1, 2, -1);
  const Mat3<Real> there = inertia_about(body, point);
  const MassProperties<Real> back =
      from_inertia_about(point, there, body.mass, body.centre_of_mass);
  // Both ways shift by the same bits; what rounds is one sum and one difference.
  CHECK((back.inertia - body.inertia).norm() <= 3 * unit_roundoff<Real> * there.norm());
}

TEST_CASE_TEMPLATE("A body made of parts is the body made of all their particles", Real,
                   EVERY_PRECISION) {
  const std::vector<Particle<Real>> first = lump<Real>(9), second = lump<Real>(10);
  std::vector<Particle<Real>> all = first;
  all.insert(all.end(), second.begin(), second.end());
  const MassProperties<Real> parts =
      combined(std::vector{mass_properties(first), mass_properties(second)});
  const MassProperties<Real> whole = mass_properties(all);
  const Real size = whole.inertia.trace();
  CHECK(std::abs(parts.mass - whole.mass) <= 8 * unit_roundoff<Real> * whole.mass);
  CHECK(distance(parts.centre_of_mass, whole.centre_of_mass) <= 48 * unit_roundoff<Real>);
  CHECK((parts.inertia - whole.inertia).norm() <= 48 * unit_roundoff<Real> * size);
}

TEST_CASE_TEMPLATE(
    "A compound body far from the origin, at exact places, keeps the bits it has near it", Real,
    EVERY_PRECISION) {
  const Mat3<Real> upright = Mat3<Real>::Identity();
  const auto dumbbell = [&](const Vec3<Real>& place) {
    const MassProperties<Real> ball = mass_properties(Sphere<Real>{Real(0.1)}, 2);
    return combined(std::vector{moved(ball, upright, place - Vec3<Real>(Real(0.5), 0, 0)),
                                moved(ball, upright, place + Vec3<Real>(Real(0.5), 0, 0))});
  };
  // Halves are exact at a million metres even in float, so every difference of positions is, too.
  const MassProperties<Real> near = dumbbell(Vec3<Real>::Zero());
  const MassProperties<Real> far = dumbbell(Vec3<Real>(1'000'000, -2'000'000, 500'000));
  CHECK(same_bits(far.inertia, near.inertia));
  CHECK(same_bits(far.centre_of_mass, Vec3<Real>(1'000'000, -2'000'000, 500'000)));
}

TEST_CASE_TEMPLATE(
    "Far away the common centre of unequal parts is off by one rounding of its place", Real,
    EVERY_PRECISION) {
  const Mat3<Real> upright = Mat3<Real>::Identity();
  const MassProperties<Real> light = mass_properties(Sphere<Real>{Real(0.1)}, Real(2.2));
  const MassProperties<Real> heavy = mass_properties(Sphere<Real>{Real(0.1)}, Real(3.1));
  for (int n = 1; n <= 50; ++n) {
    const Real place = 1000 * Real(n);  // the halves around it are exact in float
    const MassProperties<Real> dumbbell =
        combined(std::vector{moved(light, upright, {place - Real(0.5), 0, 0}),
                             moved(heavy, upright, {place + Real(0.5), 0, 0})});
    const Real off = dumbbell.centre_of_mass.x() - place -
                     (heavy.mass - light.mass) / (heavy.mass + light.mass) / 2;
    CHECK(std::abs(off) <= unit_roundoff<Real> * (place + 1) + 8 * unit_roundoff<Real>);
  }
}

TEST_CASE_TEMPLATE("Moving the particles or moving their mass properties is the same", Real,
                   EVERY_PRECISION) {
  RandomGenerator dice(13);
  const Mat3<Real> R = random_turn<Real>(dice);
  const Vec3<Real> shift(3, -1, 2);
  std::vector<Particle<Real>> particles = lump<Real>(14);
  const MassProperties<Real> first = moved(mass_properties(particles), R, shift);
  for (Particle<Real>& particle : particles) particle.position = R * particle.position + shift;
  const MassProperties<Real> second = mass_properties(particles);
  // Positions after the move lie within 5 m and round 8 times at most; a moment of inertia changes
  // by twice that times the mass times distances under 2 m from the centre.
  const Real bound = 8 * unit_roundoff<Real> * 5;
  CHECK(distance(first.centre_of_mass, second.centre_of_mass) <= bound);
  CHECK((first.inertia - second.inertia).norm() <= 4 * bound * first.mass * 2);
}

TEST_CASE_TEMPLATE("A body in a mirror has mirrored products of inertia, to the bit", Real,
                   EVERY_PRECISION) {
  std::vector<Particle<Real>> particles = lump<Real>(16);
  const MassProperties<Real> body = mass_properties(particles);
  for (Particle<Real>& particle : particles) particle.position.x() *= -1;
  const MassProperties<Real> mirrored = mass_properties(particles);
  Mat3<Real> expected = body.inertia;
  for (const auto& [i, j] : {std::pair{0, 1}, {1, 0}, {0, 2}, {2, 0}}) expected(i, j) *= -1;
  CHECK(same_bits(mirrored.inertia, expected));
  CHECK(mirrored.centre_of_mass.x() == -body.centre_of_mass.x());
}

TEST_CASE_TEMPLATE("Mass or length times a power of two scales every moment by exactly its share",
                   Real, EVERY_PRECISION) {
  const auto body = [](Real mass, Real length) {
    std::vector<Particle<Real>> particles = lump<Real>(17);
    for (Particle<Real>& particle : particles) {
      particle.position *= length;
      particle.inverse_mass /= mass;
    }
    const MassProperties<Real> box =
        mass_properties(Box<Real>{Vec3<Real>(1, 2, 3) * length}, Real(0.7) * mass);
    const MassProperties<Real> capsule =
        mass_properties(Capsule<Real>{Real(0.3) * length, length}, Real(0.9) * mass);
    return combined(std::vector{mass_properties(particles), box, capsule});
  };
  const MassProperties<Real> plain = body(1, 1);
  for (const int k : {-40, -7, 13, 40}) {
    const Real factor = std::ldexp(Real(1), k), root = std::ldexp(Real(1), k / 2);
    CHECK(same_bits(body(factor, 1).inertia, factor * plain.inertia));
    CHECK(same_bits(body(1, root).inertia, root * root * plain.inertia));
  }
}

TEST_CASE_TEMPLATE("Parts, turns and shifts that make no sense are refused", Real,
                   EVERY_PRECISION) {
  const MassProperties<Real> ball = mass_properties(Sphere<Real>{1}, 2);
  const Mat3<Real> upright = Mat3<Real>::Identity();
  CHECK(complaint_of([] { combined(std::vector<MassProperties<Real>>{}); }) ==
        "a compound body needs at least one part");
  CHECK(complaint_of([&] {
          combined(std::vector{ball, MassProperties<Real>{}});
        }) == "the mass of a part is 0 kg; it must be greater than 0");
  CHECK(complaint_of([&] {
          moved(ball, 2 * upright, {0, 0, 0});
        }) ==
        "the matrix that moves a body does not turn rigidly; its columns must have length 1 and be "
        "perpendicular to each other, and one product is off by 3");
  CHECK(complaint_of([&] {
          moved(ball, -upright, {0, 0, 0});
        }) ==
        "the matrix that moves a body mirrors; its columns must be "
        "right-handed");
  CHECK(complaint_of([&] {
          moved(ball, upright, {0, 0, std::numeric_limits<Real>::infinity()});
        }) == "the shift that moves a body is (0, 0, inf) m; every component must be finite");
}

TEST_CASE_TEMPLATE("Turned to other axes a tensor is symmetric to the bit", Real, EVERY_PRECISION) {
  RandomGenerator dice(35);
  int rounded = 0;
  for (int n = 0; n < 20; ++n) {
    const Mat3<Real> R = random_turn<Real>(dice),
                     inertia = Vec3<Real>(1, 2, Real(2.5)).asDiagonal();
    const Mat3<Real> turned = in_other_axes(inertia, R), product = R * inertia * R.transpose();
    CHECK(same_bits(turned, Mat3<Real>(turned.transpose())));
    rounded += !same_bits(product, Mat3<Real>(product.transpose()));
  }
  CHECK(rounded > 0);  // the product alone is not
}

TEST_CASE_TEMPLATE("A matrix that moves a body may be off by 1024 roundings, and no more", Real,
                   EVERY_PRECISION) {
  const MassProperties<Real> box = mass_properties(Box<Real>{{1, 2, 3}}, 4);
  const auto complaint = [&](Real roundings) {
    // One column longer by so much: its square is off by twice as much.
    Mat3<Real> matrix = Mat3<Real>::Identity();
    matrix(1, 1) += roundings / 2 * unit_roundoff<Real>;
    return complaint_of([&] { moved<Real>(box, matrix, Vec3<Real>(0, 0, 0)); });
  };
  CHECK(complaint(1000) == "nothing thrown");
  CHECK(complaint(1100).find("the matrix that moves a body does not turn rigidly") == 0);
}
