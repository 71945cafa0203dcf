// SPDX-License-Identifier: Apache-2.0
#include "tribo/mixed_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine.hpp"
#include "operating_points_arrays.hpp"

namespace tribo {
namespace {

// Calls visit(first, end) for each run of neighbours for which is_alike(first, neighbour) holds.
template <class IsAlike, class Visitor>
void for_each_run(std::size_t first, std::size_t end, const IsAlike& is_alike,
                  const Visitor& visit) {
  while (first < end) {
    std::size_t next = first + 1;
    while (next < end && is_alike(first, next)) ++next;
    visit(first, next);
    first = next;
  }
}

}  // namespace

void MixedContacts::clear() {
  words_.clear();
  scenes_.clear();
  numbers_.clear();
}

void MixedContacts::add(const Scene& scene) {
  add(detail::words_of(scene), detail::numbers_of<double>(scene));
}

detail::SceneNumbers<double>& MixedContacts::add(const detail::ContactWords& words,
                                                 const detail::SceneNumbers<double>& scene) {
  words_.push_back(words);
  return scenes_.emplace_back(scene);
}

void MixedContacts::prepare() {
  const std::size_t old = numbers_.size();
  numbers_.resize(scenes_.size());
  for_each_run(
      old, scenes_.size(),
      [&](std::size_t i, std::size_t j) {
        return words_[i].shape == words_[j].shape && words_[i].model == words_[j].model &&
               words_[i].film == words_[j].film && words_[i].thermal == words_[j].thermal;
      },
      [&](std::size_t first, std::size_t end) {
        detail::prepare(words_[first], std::span(scenes_).subspan(first, end - first),
                        std::span(numbers_).subspan(first, end - first));
      });
}

MixedContact<double> MixedContacts::operator[](std::size_t i) const {
  return {words_[i], scenes_[i], numbers_[i]};
}

void MixedContacts::solve(std::span<const std::uint64_t> contact_of, std::span<const double> speeds,
                          OutputSet outputs, OperatingPoints& points) const {
  std::copy(speeds.begin(), speeds.end(), points.speed.begin());
  std::array<double, sharing_block> lambda;
  for (std::size_t start = 0; start < speeds.size(); start += lambda.size()) {
    const std::size_t stop = std::min(start + lambda.size(), speeds.size());
    for_each_run(
        start, stop,
        [&](std::size_t i, std::size_t j) {
          return words_[contact_of[i]] == words_[contact_of[j]];
        },
        [&](std::size_t first, std::size_t end) {
          detail::engine().points(words_[contact_of[first]], numbers_.data(), &contact_of[first],
                                  &speeds[first], outputs, detail::destination(points, first),
                                  lambda.data(), end - first, nullptr);
          for (std::size_t i = first; i < end; ++i)
            if (std::isnan(lambda[i - first]))
              detail::store((*this)[contact_of[i]].solve(speeds[i], outputs), points, i);
        });
  }
}

}  // namespace tribo
