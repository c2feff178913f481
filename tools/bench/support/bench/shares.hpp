/// @file
/// Work on an array in equal shares, one for each thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <future>
#include <vector>

namespace tumble::support::bench {

/// Calls work(first, end) for each share of 0 … count, the last on this thread, the others each on
/// one of its own. Shares begin at multiples of 64, so that no two touch one cache line.
template <class Work>
void in_shares(std::size_t count, int threads, const Work& work) {
  const std::size_t share = (count / static_cast<std::size_t>(threads) + 63) / 64 * 64;
  std::vector<std::future<void>> others;  // each waits for its thread when it goes
  std::size_t first = 0;
  for (int thread = 1; thread < threads; ++thread) {
    const std::size_t end = std::min(first + share, count);
    others.push_back(std::async(std::launch::async, [&work, first, end] { work(first, end); }));
    first = end;
  }
  work(first, count);
}

}  // namespace tumble::support::bench
