% SPDX-License-Identifier: Apache-2.0
% Asks tcc-modelo by Henrique Baron, a ball bearing in MATLAB, with E' = 2 E* and R_y not below R_x, as raceways have it.
addpath (getenv ("FIELD_SOURCE"));

function a = reduced_radius (q)
  [x, y, R] = RaiosCurvatura (q.first_radius_x, q.first_radius_y, q.second_radius_x, q.second_radius_y);
  a = struct ("radius_x", x, "radius_y", y, "reduced_radius", R);
endfunction
function a = hertz_ellipse (q)
  a = [];
  if (q.radius_x <= q.radius_y)
    [~, ~, R, Rd] = RaiosCurvatura (q.radius_x, q.radius_y, Inf, Inf);
    [K, E, k] = ParametrosElipseContato (Rd);
    a = struct ("ellipticity", k, "approach", DeformacaoElastica (q.load, q.effective_modulus, R, K, E, k));
  endif
endfunction
function h = hamrock_dowson_central (q)
  if (! isfield (q, "ellipticity"))
    q.ellipticity = 1;
  endif
  % Balls of no diameter at a pitch radius of 1: the raceway's speed is then the sum of both speeds.
  h = EspessuraFilmeLub (2, 0, q.reduced_radius * [1, 1], q.ellipticity * [1, 1], 2 * q.speed * [1, 1], q.load, ...
                         q.effective_modulus, q.viscosity, q.pressure_viscosity)(1);
endfunction
