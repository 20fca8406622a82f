// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/exceptions.h>

#include <boost/functional/hash.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgMesh
/// \brief Numbers the current vertices or faces of a mesh, for meshes whose elements have no
/// indices. One hash table look-up per access.
///
/// \tparam Descriptor can be compared and hashed by `boost::hash`
template <class Descriptor>
class Element_numbering {
 public:
  template <class Range>
  explicit Element_numbering(const Range& elements)
  {
    for (const auto& e : elements) m_numbers.emplace(e, m_numbers.size());
  }

  std::size_t size() const { return m_numbers.size(); }

  /// \throw Precondition_error if the element was added to the mesh later
  std::size_t operator()(const Descriptor& element) const
  {
    const auto found = m_numbers.find(element);
    if (found == m_numbers.end())
      throw Precondition_error("Associated_property_map",
                               "the element was added to the mesh after the map was made; make the "
                               "map when the mesh is complete");
    return found->second;
  }

 private:
  std::unordered_map<Descriptor, std::size_t, boost::hash<Descriptor>> m_numbers;
};

/// \ingroup PkgMesh
/// \brief A property map that owns its values, outside the mesh; copies share them.
///
/// A model of `LvaluePropertyMap`. Several maps may share one numbering. Elements are identified by
/// their `Descriptor`: if it is an address, an element that replaces an erased one inherits its
/// value.
template <class Descriptor, class Value>
class Associated_property_map {
 public:
  using key_type = Descriptor;
  using value_type = Value;
  using reference = Value&;
  using category = boost::lvalue_property_map_tag;

  Associated_property_map() = default;

  Associated_property_map(std::shared_ptr<const Element_numbering<Descriptor>> numbering,
                          const Value& initial)
      : m_numbering(std::move(numbering)),
        m_values(std::make_shared<std::vector<Value>>(m_numbering->size(), initial))
  {}

  reference operator[](const key_type& key) const { return (*m_values)[(*m_numbering)(key)]; }

  friend reference get(const Associated_property_map& map, const key_type& key) { return map[key]; }
  friend void put(const Associated_property_map& map, const key_type& key, const value_type& value)
  {
    map[key] = value;
  }

 private:
  std::shared_ptr<const Element_numbering<Descriptor>> m_numbering;
  std::shared_ptr<std::vector<Value>> m_values;
};

}  // namespace Conformal_geometry_processing::internal
