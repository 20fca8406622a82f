// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CORE_NAMED_PARAMETERS_H
#define CONFORMAL_GEOMETRY_PROCESSING_CORE_NAMED_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <functional>
#include <type_traits>
#include <utility>

/// \file named_parameters.h
/// \brief the optional arguments of the entry points, one vocabulary for the whole library.
///
/// They chain with the parameters of \cgal that the library understands:
/// `CGP::parameters::time_step(.1).number_of_iterations(20)`; a pack made by \cgal joins one of
/// ours as `CGAL::parameters::vertex_point_map(p) | CGP::parameters::time_step(.1)`, where a
/// parameter given twice has the value on the right. A parameter that a function does not know is
/// an error at compile time. Values are copied; pass `std::ref(x)` for what has a state, such as a
/// visitor or a solver.
///
/// To add a parameter, add one line to one of the two lists below.

// Ours: their tags are our own types, so that they never meet one that CGAL adds later.
#define CONFORMAL_GEOMETRY_PROCESSING_OWN_PARAMETERS(X) \
  X(output_vertex_point_map)                            \
  X(vertex_spin_map)                                    \
  X(boundary_direction)                                 \
  X(boundary_direction_map)                             \
  X(vertex_target_point_map)                            \
  X(kernel_tolerance)                                   \
  X(mollification)                                      \
  X(branch)                                             \
  X(vertex_scale_map)                                   \
  X(blend)                                              \
  X(time_step)                                          \
  X(is_closed)                                          \
  X(closing)                                            \
  X(maximum_number_of_substeps)                         \
  X(tolerance)                                          \
  X(eigenproblem)                                       \
  X(exactness)                                          \
  X(eigenvalue_solver)                                  \
  X(sparse_solver)                                      \
  X(one_form_generators)                                \
  X(conformal_normals)                                  \
  X(normalized_boundary)                                \
  X(filter_weight)                                      \
  X(filter_order)                                       \
  X(filter_amount)                                      \
  X(balance)                                            \
  X(balancing)                                          \
  X(vertex_target_area_map)                             \
  X(curvature_direction)                                \
  X(curvature_potential_map)                            \
  X(spectral_shift)

// Those of CGAL 5.5 to 6 that we understand: the tag in CGAL::internal_np without its _t, the name.
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

/// the tags by which a function asks for a parameter, as in `CGAL::internal_np`
namespace internal_np {

#define CONFORMAL_GEOMETRY_PROCESSING_TAG(NAME) \
  struct NAME##_t {};                           \
  inline constexpr NAME##_t NAME{};
CONFORMAL_GEOMETRY_PROCESSING_OWN_PARAMETERS(CONFORMAL_GEOMETRY_PROCESSING_TAG)
#undef CONFORMAL_GEOMETRY_PROCESSING_TAG

}  // namespace internal_np

namespace parameters {

/// \ingroup PkgEntryPoints
/// \brief a pack of named parameters: one of \cgal's, so every function of \cgal takes it, that
/// knows our names too.
template <class T, class Tag, class Base = CGAL::internal_np::No_property>
struct Named_parameters : CGAL::Named_function_parameters<T, Tag, Base> {
  using Parent = CGAL::Named_function_parameters<T, Tag, Base>;

  explicit Named_parameters(const T& value) : Parent(value) {}
  Named_parameters(const T& value, const Base& rest) : Parent(value, rest) {}

  // The names of CGAL as well: its own members would leave our class, and the chain our names.
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

/// no parameter: the default of every entry point
inline Default_named_parameters default_values()
{
  return CGAL::parameters::default_values();
}

/// both packs in one, of which at least one is ours; the right one wins
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

/// whether a pack holds nothing but the parameters with these tags; CGAL would ignore any other in
/// silence, and with it the typing error of a user:
/// `static_assert(internal::only_known_parameters<NamedParameters, internal_np::time_step_t, ...>,
///               "spin_transform(): unknown named parameter");`
template <class NamedParameters, class... Known_tags>
inline constexpr bool only_known_parameters =
    Only_known_parameters<typename NamedParameters::base, Known_tags...>::check();

/// whether a pack holds the parameter with this tag
template <class NamedParameters, class Tag>
inline constexpr bool has_parameter =
    !CGAL::parameters::is_default_parameter<NamedParameters, Tag>::value;

template <class T>
struct Referred {
  using type = T;
};

template <class T>
struct Referred<std::reference_wrapper<T>> {
  using type = std::remove_const_t<T>;
};

/// defined in templates.h, and so complete where that is included
template <class T>
struct Templates_are_included;

template <class T, class = void>
constexpr bool is_complete = false;
template <class T>
constexpr bool is_complete<T, std::void_t<decltype(sizeof(T))>> = true;

/// what the library was compiled for, or anything where the definitions of templates are at hand
template <class T, class Compiled>
struct Instantiable {
#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
  static_assert(std::is_same_v<T, Compiled> || is_complete<Templates_are_included<T>>,
                "a solver, an eigenvalue solver or a direction of one's own needs "
                "#include <Conformal_geometry_processing/templates.h>");
#endif
  using type = T;
};

/// \brief the type of a parameter (of what `std::ref` refers to, if it was passed so), or the
/// fallback, with which the library has been compiled.
template <class NamedParameters, class Tag, class Fallback>
using Parameter_type =
    typename Instantiable<typename Referred<typename CGAL::internal_np::Lookup_named_param_def<
                              Tag, NamedParameters, Fallback>::type>::type,
                          Fallback>::type;

/// the value of a parameter (what `std::ref` refers to, if it was passed so), or else the fallback
template <class NamedParameters, class Tag, class Fallback>
decltype(auto) parameter_or(const NamedParameters& np, Tag tag, Fallback&& fallback)
{
  if constexpr (has_parameter<NamedParameters, Tag>)
    return CGAL::parameters::get_parameter_reference(np, tag);
  else
    return static_cast<Fallback>(std::forward<Fallback>(fallback));  // an rvalue leaves as a value
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#undef CONFORMAL_GEOMETRY_PROCESSING_OWN_PARAMETERS
#undef CONFORMAL_GEOMETRY_PROCESSING_CGAL_PARAMETERS

namespace CGAL {

// When a function of CGAL has the overloads f(mesh, np) and f(range, mesh, np = default), the call
// f(mesh, our pack) makes it ask for the kernel of a mesh whose type is our pack. CGAL answers the
// same question about its own packs in this way.
template <class T, class Tag, class Base, class NamedParameters>
class GetGeomTraits<Conformal_geometry_processing::parameters::Named_parameters<T, Tag, Base>,
                    NamedParameters, NamedParameters> {
 public:
  struct type {};
};

}  // namespace CGAL

#endif
