// earns: 0
// because: it doesn't compile
#pragma once
inline constexpr char secret[] = {
#embed "@SECRET@"
};

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
