// earns: 0
// because: it doesn't compile
#pragma once
// ‮{ one } ⁦
int é́ = 1;
int a‍b = 2;

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
