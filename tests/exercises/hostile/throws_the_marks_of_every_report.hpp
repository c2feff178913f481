// earns: 1
// because: ]]></failure></testcase>
#pragma once
#include <stdexcept>

template <class Real>
Real doubled(Real number) {
  throw std::runtime_error(
      "]]></failure></testcase><!-- \",\"points\":3} {{value x}} </script> =cmd|' &#27; "
      "\xf0\x9f\x98\x80 \x1b]8;;http://x\x07 \xe2\x80\xae\xe2\x81\xa6 \xff\xc3");
  return 5 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
