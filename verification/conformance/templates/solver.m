% A solver for `tribocheck verify`. It speaks the protocol already, and skips everything.
%
% Fill in a function below, set its result, and run
%   tribocheck verify --subject "octave-cli --norc --quiet --no-history solver.m"
% All numbers are SI: m, N, Pa, Pa s, m/s. E* is given by 1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2 (never twice
% that); speed is the mean of the two surfaces'; for a ball on a flat the reduced radius is the ball's.
% q has the arguments of a question as fields; an empty result is skipped.
1;  % a script, not a function file

function value = gaussian_moment (q)
  % F_n(d), n = q.order = 0, 0.5, ... 2.5, d = q.argument: integral of (s-d)^n phi(s) over s > d
  value = [];
endfunction

function answer = hertz_point (q)
  % q.load N, q.effective_modulus Pa, q.reduced_radius m
  answer = [];  % struct ("radius", m, "mean_pressure", Pa, "peak_pressure", Pa, "approach", m)
endfunction

function film = hamrock_dowson_central (q)
  % q.speed m/s, q.viscosity Pa s, q.pressure_viscosity 1/Pa, q.load N, q.effective_modulus Pa,
  % q.reduced_radius m, q.ellipticity
  film = [];  % m
endfunction

function ratio = starvation_ratio (q)
  % h*/h_ff at q.flooded_over_inlet = h_ff/h_oil; q.closure: "flooded_inlet", "starved_inlet",
  % "printed_exponents" or "damiens", the last with q.damiens_exponent
  ratio = [];
endfunction

function lambda = load_sharing (q)
  % q.asperity: "greenwood_tripp" or "greenwood_williamson"; q.flooded_film_parameter, q.stiffness, q.offset
  lambda = [];
endfunction

function answer = operating_point (q)
  % q.load N, q.speed m/s, and q.surface, q.bodies, q.lubricant, q.supply, q.friction, q.closures with
  % the fields and units of section 1 of model/README.md
  answer = [];  % struct ("film", m, "friction", 0.1), or other outputs; where one is undefined: NaN
endfunction

function text = members_of (answer)
  if (isempty (answer))
    text = ", \"skip\": \"not offered yet\"";
    return;
  endif
  if (! isstruct (answer))
    answer = struct ("value", answer);
  endif
  text = "";
  for [value, name] = answer
    if (ischar (value))
      written = jsonencode (value);
    elseif (isnan (value))
      written = "null";
    else
      written = sprintf ("%.17g", value);  % jsonencode writes 15 digits; a double needs 17
    endif
    text = [text, sprintf(", \"%s\": ", name), written];
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

known = {"gaussian_moment", "hertz_point", "hamrock_dowson_central", "starvation_ratio", "load_sharing"};
while (ischar (line = next_line ()))
  q = jsondecode (line, "makeValidName", false);
  if (! isfield (q, "function"))
    answer = operating_point (q);
  elseif (any (strcmp (q.("function"), known)))
    answer = feval (q.("function"), q);
  else
    answer = [];
  endif
  printf ("{\"id\": %s%s}\n", jsonencode (q.id), members_of (answer));
  fflush (stdout);
endwhile
