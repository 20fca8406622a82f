# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# The pictures of the manual. The target figure_<name> draws doc/figures/<name>.png or .svg anew,
# from what the examples write; figures draws all of them. Those of measurements, which take hours
# and a quiet machine, come with their pages: benchmark/deformers, benchmark/performance, ...
#
# Without a screen: examples/render runs f3d under xvfb (the group "picture" in .packages).

find_package(Python3 QUIET COMPONENTS Interpreter)
if(NOT Python3_FOUND OR NOT CGP_BUILD_EXAMPLES)
  return()
endif()
add_custom_target(figures)

# cgp_figure(<name> <program doc/draw_...> <examples that it runs>...)
function(cgp_figure name drawing)
  add_custom_target(figure_${name}
    COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/${drawing} ${name}
            --build-dir ${PROJECT_BINARY_DIR} --work ${PROJECT_BINARY_DIR}/figures
    USES_TERMINAL VERBATIM)
  foreach(example IN LISTS ARGN)
    if(TARGET ${example})
      add_dependencies(figure_${name} ${example})
    endif()
  endforeach()
  add_dependencies(figures figure_${name})
endfunction()

cgp_figure(first_row draw_bear first_program)
cgp_figure(bear_painted draw_bear paint_curvature)
cgp_figure(drag_a_handle draw_bear drag_a_handle)
cgp_figure(fair_a_hole draw_bear fair_a_hole)
cgp_figure(characters draw_characters conformal)
cgp_figure(first_picture draw_python conformal_geometry)
cgp_figure(notebook draw_python conformal_geometry)
cgp_figure(paint_and_filter draw_painting paint_and_filter)
cgp_figure(bear_to_sphere draw_flows conformal)
cgp_figure(torus_uncurled draw_flows conformal)
cgp_figure(html_report draw_html_report conformal)
cgp_figure(painted_page draw_painted_page conformal)
cgp_figure(stroke draw_stroke conformal)
cgp_figure(minimal_surface draw_bounded_surfaces minimal_surface)
cgp_figure(soap_film_cmc draw_bounded_surfaces soap_film_cmc)
cgp_figure(bend_the_boundary draw_bounded_surfaces bend_the_boundary)
cgp_figure(flatten_a_face draw_flat_face flatten_a_face)
cgp_figure(nearest_to_a_bend draw_nearest_and_blend nearest_to_a_bend)
cgp_figure(blend_two_shapes draw_nearest_and_blend blend_two_shapes)
cgp_figure(dirac_spheres draw_dirac_spheres conformal dirac_spheres)
cgp_figure(eigenvalues_of_a_sphere draw_dirac_spheres conformal)
cgp_figure(smoothest_torus draw_tori smoothest_torus)
cgp_figure(vesicles draw_vesicles conformal)
cgp_figure(unwind_a_curve draw_curves unwind_a_curve)
cgp_figure(many_edits draw_edits_and_fields many_edits)
cgp_figure(own_solver draw_edits_and_fields own_solver)
cgp_figure(average_rotations draw_rotations average_rotations)
cgp_figure(fields_along_handles draw_edits_and_fields fields_along_handles)
