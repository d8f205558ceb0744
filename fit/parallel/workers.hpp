#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace trunk {

/// Calls work(item) for every item on `threads` threads (0: one thread per core). Calls take(result) for each
/// result on the calling thread, in order of arrival. Results wait in a short queue, so memory does not grow
/// if `take` is slower than `work`. The work ends early once `cancelled` returns true. `work` must not throw;
/// an exception of `take` ends the work and is thrown again.
template <class Result>
void work_off(const std::vector<std::size_t>& items, unsigned threads, const std::function<bool()>& cancelled,
              const std::function<Result(std::size_t)>& work, const std::function<void(Result)>& take) {
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  const std::size_t longest_queue = 4 * static_cast<std::size_t>(threads);
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> stop = false;
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Result> queue;
  unsigned working = threads;

  const auto worker = [&] {
    for (std::size_t at = next++; at < items.size() && !stop; at = next++) {
      Result result = work(items[at]);
      std::unique_lock lock(mutex);
      changed.wait(lock, [&] { return queue.size() < longest_queue || stop; });
      queue.push_back(std::move(result));
      changed.notify_all();
    }
    const std::lock_guard lock(mutex);
    --working;
    changed.notify_all();
  };
  const auto next_result = [&]() -> std::optional<Result> {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return !queue.empty() || working == 0; });
    if (queue.empty()) return std::nullopt;
    std::optional<Result> result(std::move(queue.front()));
    queue.pop_front();
    changed.notify_all();
    return result;
  };
  const auto halt = [&] {
    stop = true;
    const std::lock_guard lock(mutex);
    changed.notify_all();
  };

  std::vector<std::jthread> pool;
  try {
    for (unsigned t = 0; t < threads; ++t) pool.emplace_back(worker);
    while (std::optional<Result> result = next_result()) {
      take(std::move(*result));
      if (cancelled && cancelled()) halt();
    }
  } catch (...) {
    halt();
    throw;
  }
}

}  // namespace trunk
