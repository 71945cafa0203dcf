% SPDX-License-Identifier: Apache-2.0
% Answers the lines of `tribocheck verify` by the functions of a file: octave-cli answering.m FILE. A function gets the question as
% a structure, and returns a number, a structure of results, or [] for what it does not have.
1;

function line = next_line ()
  % fgetl would wait for a sign of the line after this one; at the end of stdin input fails
  try
    line = input ("", "s");
  catch
    line = -1;
  end_try_catch
endfunction

source (argv (){end});
while (ischar (line = next_line ()))
  question = jsondecode (line, "makeValidName", false);
  result = [];
  text = ", \"skip\": \"it is not offered here\"";
  try
    if (isfield (question, "function") && exist (question.("function")) == 103)
      printed = evalc ("result = feval (question.(\"function\"), question);");
    endif
    if (isstruct (result))
      text = "";
      for [value, name] = result
        text = [text, sprintf(", \"%s\": %.17g", name, value)];
      endfor
    elseif (! isempty (result))
      text = sprintf (", \"value\": %.17g", result);
    endif
  catch problem
    text = [", \"error\": ", jsonencode(problem.message)];
  end_try_catch
  printf ("{\"id\": %s%s}\n", jsonencode (question.id), text);
  fflush (stdout);
endwhile
