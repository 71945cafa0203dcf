% SPDX-License-Identifier: Apache-2.0
% Asks contact_mechanics by Pedro Del Negro Tayer, scripts for Octave: E* as two bodies with nu = 0, and flat second faces.
% Its films of lines are not asked: Octave 7 does not read thickness_EHL_linear.m.
for part = {"Hertz", "Thickness", "Lubricant"}
  addpath (fullfile (getenv ("FIELD_SOURCE"), "contact_mechanics", part{1}));
endfor

function E = effective_modulus (q)
  E = hertz_theory_linear (q.first_poisson_ratio, q.first_modulus, q.second_poisson_ratio, q.second_modulus, 1, Inf, 1, 1, 0).Ecomb;
endfunction
function a = hertz_line (q)
  h = hertz_theory_linear (0, 2 * q.effective_modulus, 0, 2 * q.effective_modulus, q.reduced_radius, Inf, q.load_per_length, 1, 0);
  a = struct ("half_width", h.a, "mean_pressure", h.pm, "peak_pressure", h.po, "peak_shear", h.taumax);
endfunction
function a = hertz_ellipse (q)
  h = hertz_theory_elliptical (0, 2 * q.effective_modulus, 0, 2 * q.effective_modulus, q.radius_x, Inf, q.radius_y, Inf, q.load, 0, false);
  [x, y] = {h.a, h.b}{[1, 2] + h.inverted * [1, -1]};
  a = struct ("semi_axis_x", x, "semi_axis_y", y, "ellipticity", y / x, "mean_pressure", h.pm, "peak_pressure", h.po, "approach", h.delta);
endfunction
function h = point_film (q)  % its R_x is 2 R_x, as hertz_theory_elliptical has it, and its speed the sum of both
  h = thickness_EHL_elliptical (q.load, 2 * q.radius_x, 2 * q.radius_y, q.effective_modulus, q.viscosity, q.pressure_viscosity, 2 * q.speed);
endfunction
function h = hamrock_dowson_central (q), h = point_film (q).h0_without_correction; endfunction
function h = hamrock_dowson_minimum (q), h = point_film (q).hm_without_correction; endfunction
function nu = astm_d341_viscosity (q)
  lubricant = lub_astm_D341 (0.7, 1e6 * q.first_viscosity, 1e6 * q.second_viscosity, q.second_temperature, q.first_temperature, q.temperature);
  nu = 1e-6 * lubricant.visc_cin;
endfunction
