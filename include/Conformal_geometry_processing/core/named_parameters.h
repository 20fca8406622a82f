// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <functional>
#include <type_traits>
#include <utility>

/// \file named_parameters.h
/// \brief The optional arguments of the entry points, with the same names in the whole library.
///
/// They can be chained with the parameters of \cgal that the library supports:
/// `CGP::parameters::time_step(.1).number_of_iterations(20)`; a pack created by \cgal is combined
/// with one of this library as `CGAL::parameters::vertex_point_map(p) |
/// CGP::parameters::time_step(.1)`, where the value on the right takes precedence. A parameter that
/// a function does not support is an error at compile time. Values are copied; pass `std::ref(x)`
/// for objects with state, such as a visitor or a solver.
///
/// To add a parameter, add one line to one of the two lists below.

// Parameters of this library: their tags are separate types, to avoid collisions with CGAL.
#define CONFORMAL_GEOMETRY_PROCESSING_OWN_PARAMETERS(X) \
  X(output_vertex_point_map)                            \
  X(vertex_spin_map)                                    \
  X(boundary_direction)                                 \
  X(boundary_direction_map)                             \
  X(vertex_target_point_map)                            \
  X(position_weight)                                    \
  X(dirac)                                              \
  X(mollification)                                      \
  X(vertex_region_map)                                  \
  X(vertex_scale_map)                                   \
  X(vertex_scale_weight_map)                            \
  X(scale_bound)                                        \
  X(blend)                                              \
  X(fit)                                                \
  X(time_step)                                          \
  X(is_closed)                                          \
  X(tolerance)                                          \
  X(exactness)                                          \
  X(exact_conformal_class)                              \
  X(reduced_volume)                                     \
  X(limits)                                             \
  X(sparse_solver)                                      \
  X(filter)                                             \
  X(balance)                                            \
  X(vertex_target_area_map)                             \
  X(curvature_direction)                                \
  X(curvature_potential_map)                            \
  X(spectral_shift)

// Supported parameters of CGAL 5.5 to 6: the tag in CGAL::internal_np without its _t, the name.
#define CONFORMAL_GEOMETRY_PROCESSING_CGAL_PARAMETERS(X) \
  X(vertex_point, vertex_point_map)                      \
  X(point, point_map)                                    \
  X(vertex_normal_map, vertex_normal_map)                \
  X(vertex_is_constrained, vertex_is_constrained_map)    \
  X(geom_traits, geom_traits)                            \
  X(number_of_iterations, number_of_iterations)          \
  X(random_seed, random_seed)                            \
  X(visitor, visitor)

namespace Conformal_geometry_processing {

/// Tags with which functions look up parameters, as in `CGAL::internal_np`
namespace internal_np {

#define CONFORMAL_GEOMETRY_PROCESSING_TAG(NAME) \
  struct NAME##_t {};                           \
  inline constexpr NAME##_t NAME{};
CONFORMAL_GEOMETRY_PROCESSING_OWN_PARAMETERS(CONFORMAL_GEOMETRY_PROCESSING_TAG)
#undef CONFORMAL_GEOMETRY_PROCESSING_TAG

}  // namespace internal_np

namespace parameters {

/// \ingroup PkgEntryPoints
/// \brief A pack of named parameters: derived from \cgal's, so every function of \cgal accepts it,
/// and extended by the names of this library.
template <class T, class Tag, class Base = CGAL::internal_np::No_property>
struct Named_parameters : CGAL::Named_function_parameters<T, Tag, Base> {
  using Parent = CGAL::Named_function_parameters<T, Tag, Base>;

  explicit Named_parameters(const T& value) : Parent(value) {}
  Named_parameters(const T& value, const Base& rest) : Parent(value, rest) {}

  // Redefines CGAL's names, because its own members would return packs without our names.
#define CONFORMAL_GEOMETRY_PROCESSING_OWN_MEMBER(NAME)                                     \
  template <class Value>                                                                   \
  auto NAME(const Value& value) const                                                      \
  {                                                                                        \
    return Named_parameters<Value, internal_np::NAME##_t, Named_parameters>(value, *this); \
  }
#define CONFORMAL_GEOMETRY_PROCESSING_CGAL_MEMBER(TAG, NAME)                                    \
  template <class Value>                                                                        \
  auto NAME(const Value& value) const                                                           \
  {                                                                                             \
    return Named_parameters<Value, CGAL::internal_np::TAG##_t, Named_parameters>(value, *this); \
  }
  CONFORMAL_GEOMETRY_PROCESSING_OWN_PARAMETERS(CONFORMAL_GEOMETRY_PROCESSING_OWN_MEMBER)
  CONFORMAL_GEOMETRY_PROCESSING_CGAL_PARAMETERS(CONFORMAL_GEOMETRY_PROCESSING_CGAL_MEMBER)
#undef CONFORMAL_GEOMETRY_PROCESSING_OWN_MEMBER
#undef CONFORMAL_GEOMETRY_PROCESSING_CGAL_MEMBER
};

#define CONFORMAL_GEOMETRY_PROCESSING_OWN_FUNCTION(NAME)          \
  template <class Value>                                          \
  auto NAME(const Value& value)                                   \
  {                                                               \
    return Named_parameters<Value, internal_np::NAME##_t>(value); \
  }
#define CONFORMAL_GEOMETRY_PROCESSING_CGAL_FUNCTION(TAG, NAME)         \
  template <class Value>                                               \
  auto NAME(const Value& value)                                        \
  {                                                                    \
    return Named_parameters<Value, CGAL::internal_np::TAG##_t>(value); \
  }
CONFORMAL_GEOMETRY_PROCESSING_OWN_PARAMETERS(CONFORMAL_GEOMETRY_PROCESSING_OWN_FUNCTION)
CONFORMAL_GEOMETRY_PROCESSING_CGAL_PARAMETERS(CONFORMAL_GEOMETRY_PROCESSING_CGAL_FUNCTION)
#undef CONFORMAL_GEOMETRY_PROCESSING_OWN_FUNCTION
#undef CONFORMAL_GEOMETRY_PROCESSING_CGAL_FUNCTION

using Default_named_parameters = CGAL::parameters::Default_named_parameters;

/// No parameters: the default of every entry point
inline Default_named_parameters default_values()
{
  return CGAL::parameters::default_values();
}

/// Combines two packs, at least one of which is ours; the right one takes precedence
template <class T, class Tag, class Base, class T2, class Tag2, class Base2>
auto operator|(const CGAL::Named_function_parameters<T, Tag, Base>& left,
               const CGAL::Named_function_parameters<T2, Tag2, Base2>& right)
{
  if constexpr (std::is_same_v<Base2, CGAL::internal_np::No_property>) {
    using Left = CGAL::Named_function_parameters<T, Tag, Base>;
    return Named_parameters<T2, Tag2, Left>(right.v, left);
  } else {
    const auto rest = parameters::operator|(left, static_cast<const Base2&>(right));
    return Named_parameters<T2, Tag2, std::decay_t<decltype(rest)>>(right.v, rest);
  }
}

}  // namespace parameters

namespace internal {

template <class Parameters, class... Known_tags>
struct Only_known_parameters;

template <class T, class Tag, class Base, class... Known_tags>
struct Only_known_parameters<CGAL::internal_np::Named_params_impl<T, Tag, Base>, Known_tags...> {
  static constexpr bool is_known = std::is_same_v<Tag, CGAL::internal_np::all_default_t> ||
                                   (std::is_same_v<Tag, Known_tags> || ...);

  static constexpr bool check()
  {
    if constexpr (std::is_same_v<Base, CGAL::internal_np::No_property>)
      return is_known;
    else
      return is_known && Only_known_parameters<typename Base::base, Known_tags...>::check();
  }
};

/// Whether a pack contains only parameters with these tags; CGAL would silently ignore any other
/// one, including misspelled names:
/// `static_assert(internal::only_known_parameters<NamedParameters, internal_np::time_step_t, ...>,
///               "spin_transform(): unknown named parameter");`
template <class NamedParameters, class... Known_tags>
inline constexpr bool only_known_parameters =
    Only_known_parameters<typename NamedParameters::base, Known_tags...>::check();

/// Whether a pack contains the parameter with this tag
template <class NamedParameters, class Tag>
inline constexpr bool has_parameter =
    !CGAL::parameters::is_default_parameter<NamedParameters, Tag>::value;

/// Sets a value to that of the parameter with a tag, if the pack has it
template <class NamedParameters, class Tag, class Value>
void read_parameter(const NamedParameters& np, Tag tag, Value& value)
{
  if constexpr (!has_parameter<NamedParameters, Tag>)
    return;
  else if constexpr (std::is_same_v<Value, double>)  // of any field
    value = CGAL::to_double(CGAL::parameters::get_parameter_reference(np, tag));
  else
    value = static_cast<Value>(CGAL::parameters::get_parameter_reference(np, tag));
}

/// Returns the value of a parameter (the object that `std::ref` refers to), or else the fallback
template <class NamedParameters, class Tag, class Fallback>
decltype(auto) parameter_or(const NamedParameters& np, Tag tag, Fallback&& fallback)
{
  if constexpr (has_parameter<NamedParameters, Tag>)
    return CGAL::parameters::get_parameter_reference(np, tag);
  else
    return static_cast<Fallback>(std::forward<Fallback>(fallback));  // returns rvalues by value
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#undef CONFORMAL_GEOMETRY_PROCESSING_OWN_PARAMETERS
#undef CONFORMAL_GEOMETRY_PROCESSING_CGAL_PARAMETERS

namespace CGAL {

// If a function of CGAL has the overloads f(mesh, np) and f(range, mesh, np = default), the call
// f(mesh, our pack) makes it look up the kernel of a mesh whose type is our pack. CGAL has the same
// specialization for its own packs.
template <class T, class Tag, class Base, class NamedParameters>
class GetGeomTraits<Conformal_geometry_processing::parameters::Named_parameters<T, Tag, Base>,
                    NamedParameters, NamedParameters> {
 public:
  struct type {};
};

}  // namespace CGAL
