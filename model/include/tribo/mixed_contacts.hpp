// SPDX-License-Identifier: Apache-2.0
// Many contacts at once, in double: prepared and solved in vectors across contacts, for sweeps in
// which each scene is a different one. The bits are those of MixedContact<double>.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tribo/mixed_contact.hpp"
#include "tribo/operating_points.hpp"

namespace tribo {

class MixedContacts {
 public:
  void clear();
  // Adds the contact of a scene, whose fields must be in range. The contact can be used once
  // prepare() has been called after this.
  void add(const Scene& scene);
  // Adds a contact and returns its numbers, which may be changed until the next add() or prepare().
  detail::SceneNumbers<double>& add(const detail::ContactWords& words,
                                    const detail::SceneNumbers<double>& scene);
  void prepare();

  // The number of contacts that were added.
  std::size_t size() const { return scenes_.size(); }
  MixedContact<double> operator[](std::size_t i) const;

  // All outputs of a set into `points`, which must have room for them. Point i belongs to contact
  // contact_of[i] < size() and speeds[i] in m/s. Error: operating_point_contract.
  void solve(std::span<const std::uint64_t> contact_of, std::span<const double> speeds,
             OutputSet outputs, OperatingPoints& points) const;

 private:
  std::vector<detail::ContactWords> words_;
  std::vector<detail::SceneNumbers<double>> scenes_;
  std::vector<detail::ContactNumbers<double>> numbers_;
};

}  // namespace tribo
