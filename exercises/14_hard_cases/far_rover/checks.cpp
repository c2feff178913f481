#include <exercise/judge.hpp>
#include <tumble/far_from_origin.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

const Precondition whole_cells[] = {{"settle", 0, whole},
                                    {"way_between", 0, whole},
                                    {"way_between", 2, whole},
                                    {"driven", 0, whole}};

template <class Real>
struct Place {
  Vec3<Real> cell, offset;
};
template <class Real>
void get(Words& words, Place<Real>& place) {
  using tumble::exercise::get;
  get(words, place.cell);
  get(words, place.offset);
}

template <class Real>
Place<Real> settled(const Vec3<Real>& cell, const Vec3<Real>& offset) {
  return ask<Place<Real>>("settle", cell, offset);
}

/// A cell so far away that a coordinate there knows no millimetres: 10 000 km in float, a
/// tenth of a light year in double.
template <class Real>
constexpr Real far_cell = sizeof(Real) == 4 ? Real(10001) : Real(1099511627777);

template <class Real>
std::vector<Vec3<Real>> offsets() {
  return {{Real(100.125), Real(-511.5), 0},
          {Real(700.0625), Real(-700.0625), Real(513)},
          {Real(5000.5), Real(-123456.25), Real(2047.9375)},
          {Real(-1535.75), Real(1537), Real(-512.25)}};
}

}  // namespace

EXERCISE_CHECK("Carrying whole cells moves nothing, to the bit") {
  for (const Vec3<Real>& offset : offsets<Real>())
    for (const Real first : {Real(0), Real(-7), far_cell<Real>}) {
      const Vec3<Real> cell(first, 3, -2);
      const auto now = settled<Real>(cell, offset);
      for (int axis = 0; axis < 3; ++axis) {
        const double cells = double(now.cell[axis] - cell[axis]);
        const double moved = 1024 * cells + (double(now.offset[axis]) - double(offset[axis]));
        const std::string what =
            sentence("an offset of ", offset[axis], " m in cell ", cell[axis], " became ",
                     now.offset[axis], " m, ", cells, cells == 1 ? " cell" : " cells",
                     " further: the place has moved by ", moved, " m. ");
        require(cells != 0 || !(std::abs(offset[axis]) > 1024),
                "an offset of " + shown(offset[axis]) + " m was left, and no cell was carried");
        if (moved == 0) continue;
        require(
            std::abs(moved) < 1 || std::abs(std::remainder(moved, 1024)) > 0,
            what +
                "A cell that leaves the offset must be added to the cell, and the other way round");
        fail(what + "Only a whole number of cells may be carried");
      }
      require(now.cell == Vec3<Real>(now.cell.array().round()),
              "a cell became " + shown(now.cell) + "; cells are counted in whole numbers");
    }
}

EXERCISE_CHECK("Then no offset is beyond half a cell, however far it was and to either side") {
  for (const Vec3<Real>& offset : offsets<Real>()) {
    const auto now = settled<Real>({0, 0, 0}, offset);
    for (int axis = 0; axis < 3; ++axis) {
      const Real before = offset[axis], after = now.offset[axis];
      require(after == before || !(std::abs(before) < 256),
              sentence("an offset of ", before, " m became ", after,
                       " m. It was well within its cell: there is nothing to carry"));
      if (std::abs(after) <= 512) continue;
      const std::string what = sentence("an offset of ", before, " m was left at ", after, " m. ");
      // Its opposite came before, and was right.
      require(after >= 0 || before >= 0 || before < -1024,
              what + "It may be beyond the other side as well");
      require(
          after != before || std::abs(before) > 1024,
          what +
              "Half a cell is 512 m: from there on the next cell's middle is nearer. Round to the "
              "nearest; a cast cuts off");
      require(std::abs(after) <= 1024,
              what + "One cell is not always enough: carry as many as there are");
      fail(what + "Half a cell is 512 m: take the *nearest* whole number of cells");
    }
  }
}

EXERCISE_CHECK("The way between neighbours keeps its digits, at the end of the world") {
  const Real millimetre = Real(1) / 1024;
  const Vec3<Real> offset(Real(511.5), -3, 100),
      other(Real(-512) + millimetre, -3 + millimetre, 100);
  const Vec3<Real> truth(Real(0.5) + millimetre, millimetre, 0);
  for (const Real far : {Real(0), far_cell<Real>}) {
    const Vec3<Real> cell(far, far, -far), next(far + 1, far, -far);
    const auto place = [](Real in_cell, Real at) { return Real(Real(1024 * in_cell) + at); };
    Vec3<Real> through_origin;
    for (int axis = 0; axis < 3; ++axis)
      through_origin[axis] = place(next[axis], other[axis]) - place(cell[axis], offset[axis]);
    Found("in cell " + shown(far) + " the way across the border to a neighbour", "m",
          ask<Vec3<Real>>("way_between", cell, offset, next, other))
        .mistake(through_origin,
                 "the places were made first and then subtracted. Out there a coordinate has no "
                 "such digits: "
                 "subtract cells from cells and offsets from offsets")
        .mistake(Vec3<Real>(-truth), "that is the way back. It leads from the first to the second")
        .mistake(Vec3<Real>(other - offset), "the offsets count from different cells")
        .mistake(Vec3<Real>(truth - Vec3<Real>(1023, 0, 0)),
                 "a cell counts as one metre; it is 1024 m long")
        .must_be(truth, 1024 * unit_roundoff<Real>);
  }
  const Vec3<Real> cell(far_cell<Real>, 7, -3), away = cell + Vec3<Real>(3, -2, 5);
  Found("the way to a place 3, -2 and 5 cells further, and 1, 2 and 5 m within its cell,", "m",
        ask<Vec3<Real>>("way_between", cell, Vec3<Real>(1, 2, 3), away, Vec3<Real>(2, 4, 8)))
      .must_be(Vec3<Real>(3 * 1024 + 1, -2 * 1024 + 2, 5 * 1024 + 5), 0);
}

EXERCISE_CHECK("A slow rover arrives, far away as near the origin") {
  const Real h = Real(1) / 64;
  const int steps = 6400;
  const Vec3<Real> velocity(Real(0.5), Real(-0.25), 0);
  for (const Real far : {Real(0), far_cell<Real>}) {
    const auto way = ask<Vec3<Real>>("driven", Vec3<Real>(far, -far, 0), Vec3<Real>(500, -500, 1),
                                     velocity, h, steps);
    // Each step of 1/128 and 1/256 m is a multiple of the spacing: nothing is rounded.
    Found("in cell " + shown(far) + " the way of a rover that drives (0.5, -0.25, 0) m/s for 100 s",
          "m", way)
        .mistake(Vec3<Real>::Zero(), "it has not moved")
        .must_be(Vec3<Real>(50, -25, 0), 1024 * unit_roundoff<Real>);
  }
}

EXERCISE_CHECK(
    "Nothing slower than said moves in the farthest corner of a cell, and what is faster moves "
    "anywhere") {
  const Real half = 512;
  const double spacing = double(half - std::nextafter(half, Real(0)));
  // Exactly half a cell may be left or carried to the other side. Where it is left the spacing
  // outward counts, for 512 is a power of two: twice that inward.
  may_be_off() = 1;
  const auto is_left_at = [&](Real offset) {
    const double between = 1.5 * spacing / 2 * 64;
    const Vec3<Real> outward(std::copysign(Real(between), offset), 0, 0), zero(0, 0, 0);
    return ask<Vec3<Real>>("driven", zero, Vec3<Real>(offset, 0, 0), outward, Real(1) / 64, 64)
        .isZero(0);
  };
  const bool is_left = is_left_at(half) || is_left_at(-half);
  may_be_off() = is_left ? 1 : 0;
  for (const Real h : {Real(1) / 64, Real(0.5)}) {
    const double inward = spacing / 2 / double(h), truth = is_left ? 2 * inward : inward;
    Found("the slowest speed that moves a rover in steps of " + shown(h) + " s", "m/s",
          double(ask<Real>("slowest_drive", h)))
        .mistake(double(slowest_drift_at<Real>(1024, h)),
                 "that is for an offset of a whole cell. It is never beyond half of one")
        .mistake(is_left ? inward : 2 * inward,
                 is_left
                     ? "at 1.5 times that speed your rover doesn't get away from 512 m, half a "
                       "cell: that is a power of two, where the spacing outward is twice what it "
                       "is inward. Twice the speed is right, or a settle that carries half a cell "
                       "to the other side"
                     : "twice what it should be. At 512 m, a power of two, the spacing outward "
                       "is twice what it is inward, but your settle carries a rover from there "
                       "to the other side. The offset just below counts; and half of a spacing "
                       "is enough, for a sum is rounded to the nearest")
        .mistake(truth * double(h) * double(h),
                 "divide by the time step: a speed is a way by a time")
        .must_be(truth, 4 * unit_roundoff<Real> * truth);
  }
}
