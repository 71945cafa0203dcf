#!/usr/bin/env -S octave-cli --norc --quiet --no-history
% SPDX-License-Identifier: Apache-2.0
% A solver in GNU Octave: Hertz, film, moments by quadgk, the closed forms of the starved inlet.
% Reads a question a line on stdin, answers each by a line on stdout; what it does not offer it skips.
1;  % a script, not a function file

function value = gaussian_moment (n, d)
  % integral of x^n phi(x + d) over x > 0; the waypoint is the peak, or the width beyond it
  phi = @(s) exp (-s .^ 2 / 2) / sqrt (2 * pi);
  integrand = @(x) x .^ n .* phi (x + d);
  if (d < 0)
    value = quadgk (integrand, 0, -d + 12, "AbsTol", realmin, "RelTol", 1e-11, "Waypoints", -d);
  else
    width = 40 / (2 + d);
    value = quadgk (integrand, 0, width, "AbsTol", realmin, "RelTol", 1e-11);
  endif
endfunction

function answer = hertz_point (q)
  F = q.load; E = q.effective_modulus; R = q.reduced_radius;
  a = nthroot (3 * F * R / (4 * E), 3);
  mean_pressure = F / (pi * a ^ 2);
  answer = struct ("radius", a, "mean_pressure", mean_pressure, ...
                   "peak_pressure", 1.5 * mean_pressure, "approach", a ^ 2 / R);
endfunction

function h = hamrock_dowson_central (q)
  k = 1;
  if (isfield (q, "ellipticity")) k = q.ellipticity; endif
  E = 2 * q.effective_modulus; R = q.reduced_radius;
  U = q.viscosity * q.speed / (E * R);
  G = q.pressure_viscosity * E;
  W = q.load / (E * R ^ 2);
  h = 2.69 * R * U ^ 0.67 * G ^ 0.53 * W ^ -0.067 * (1 - 0.61 * exp (-0.73 * k));
endfunction

function y = starvation_ratio (q)
  r = q.flooded_over_inlet;
  gamma = 3;
  if (isfield (q, "damiens_exponent")) gamma = q.damiens_exponent; endif
  if (strcmp (q.closure, "flooded_inlet"))
    psi = max (0, (1 - r) / r * 3 / (4 * sqrt (2))) ^ (2 / 3);
    y = 2 / pi * atan (2.7 * psi);
  elseif (strcmp (q.closure, "damiens"))
    y = (1 + r ^ gamma) ^ (-1 / gamma);
  else
    error ("subject:skip", "no closure %s", q.closure);
  endif
endfunction

function answer = answer_to (q)
  if (! isfield (q, "function"))
    error ("subject:skip", "no operating points");
  endif
  switch (q.("function"))
    case "gaussian_moment"
      answer = struct ("value", gaussian_moment (q.order, q.argument));
    case "hertz_point"
      answer = hertz_point (q);
    case "hamrock_dowson_central"
      answer = struct ("value", hamrock_dowson_central (q));
    case "starvation_ratio"
      answer = struct ("value", starvation_ratio (q));
    otherwise
      error ("subject:skip", "no function %s", q.("function"));
  endswitch
endfunction

function text = members_of (answer)
  % jsonencode writes 15 digits; a double needs 17
  text = "";
  for [value, name] = answer
    text = [text, sprintf(", \"%s\": %.17g", name, value)];
  endfor
endfunction

function line = next_line ()
  % fgetl would wait for a sign of the line after this one; at the end of stdin input fails
  try
    line = input ("", "s");
  catch
    line = -1;
  end_try_catch
endfunction

while (ischar (line = next_line ()))
  question = jsondecode (line, "makeValidName", false);
  try
    text = members_of (answer_to (question));
  catch problem
    if (strcmp (problem.identifier, "subject:skip"))
      text = [", \"skip\": ", jsonencode(problem.message)];
    else
      reason = struct ("field", "", "message", problem.message);
      text = [", \"error\": ", jsonencode(reason)];
    endif
  end_try_catch
  printf ("{\"id\": %s%s}\n", jsonencode (question.id), text);
  fflush (stdout);
endwhile
