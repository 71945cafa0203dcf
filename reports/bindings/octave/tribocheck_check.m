% text = tribocheck_check (solver, name, option, value, ...)
%
% Holds a function of yours to the certified values of a function of the catalogue:
%
%     tribocheck_check (@my_film, "hamrock_dowson_central")
%
% It gets the arguments that `help tribocheck_hamrock_dowson_central` lists, in that order and in SI units:
% as columns, or number by number where it takes none. It returns its result; of several a struct, or all of
% them as outputs in the order of the catalogue. What a struct leaves out, and questions that it answers
% with [], are not judged. An operating point (operating_point) is a struct, a scene with one speed, as is
% its answer, where NaN is a result that is undefined.
%
% solver       the function, or a struct of functions by their names in the catalogue, and then no `name`:
%              causes that follow from another function are told, too
% name         of the function in the catalogue
% "tolerance"  "engineering" (1e-6, the default), "strict" (the bound of the catalogue), or the path of a file
% "arguments"  a cell of the names of the arguments that it takes, in its order; or "struct": it takes
%              one struct, with what a question has, as the functions of `tribocheck init subject` do
% "units"      a struct of other units, of arguments and results: struct ("viscosity", "mPa s")
% "modulus"    "E'" where it takes E' = 2E*; "bodies" where "arguments" name those of both bodies
% "ellipticity" "radii" where "arguments" name radius_x and radius_y of a film
% "sample"     cases of each function at most; 0: all
% "subject"    the solver's name in the verdict
%
% Returns the verdict. It is an error, with the worst case and the cause as `tribocheck verify --subject`
% tells them, where something fails or nothing is answered.

% SPDX-License-Identifier: Apache-2.0
function text = tribocheck_check (solver, varargin)
  subject = 'the solver';
  if ~isstruct (solver)
    if ~isa (solver, 'function_handle') || isempty (varargin) || ~ischar (varargin{1})
      error ('tribocheck:argument', 'tribocheck_check: a function is wanted, and its name in the catalogue');
    end
    subject = func2str (solver);
    solver = struct (varargin{1}, solver);
    varargin(1) = [];
  end
  request = struct ('tolerance', 'engineering', 'modulus', 'E*', 'ellipticity', 'k', 'sample', 0, 'subject', subject);
  own = struct ('arguments', [], 'units', struct ());
  for k = 1:2:numel (varargin)
    option = varargin{k};
    if ~ischar (option) || ~(isfield (request, option) || isfield (own, option))
      error ('tribocheck:argument', 'tribocheck_check: argument %d is no option; allowed: %s', k + 2, ...
             strjoin ([fieldnames(request); fieldnames(own)]', ', '));
    elseif k == numel (varargin)
      error ('tribocheck:argument', 'tribocheck_check: %s has no value', option);
    elseif isfield (own, option)
      own.(option) = varargin{k + 1};
    else
      request.(option) = varargin{k + 1};
    end
  end
  names = fieldnames (solver);
  refuse_unknown (names, own.units);
  for k = 1:numel (names)
    request.functions = names(k);
    questions{k} = strsplit (strtrim (told ('cases', jsonencode (request))), char (10));
  end
  request.functions = names;
  answers = @(as_columns) cellfun (@(name, lines) answers_of (solver.(name), name, lines, own, as_columns), ...
                                   names(:)', questions, 'UniformOutput', false);
  first = answers (true);
  [text, code] = judged (request, first);
  % A function whose branches or products are those of numbers may give wrong columns without an error.
  if code ~= 0
    alone = answers (false);
    if ~isequal (alone, first)
      [text, code] = judged (request, alone);
    end
  end
  if code ~= 0
    error ('tribocheck:wrong', '%s', text);
  end
end

% A unit for a name that no function has would be left aside, and the verdict be on another function.
function refuse_unknown (functions, units)
  if ~isstruct (units)
    error ('tribocheck:argument', 'tribocheck_check: units: a struct is wanted, as struct ("viscosity", "mPa s")');
  end
  all = catalogue ();
  known = {};
  for one = functions(isfield (all, functions))'
    entry = all.(one{1});
    known = [known, entry.arguments, entry.fields];
  end
  unknown = setdiff (fieldnames (units), known);
  if ~isempty (unknown)
    error ('tribocheck:argument', 'tribocheck_check: units: "%s" is no argument or result of %s; allowed: %s', unknown{1}, ...
           strjoin (functions', ', '), strjoin (unique (known), ', '));
  end
end

function [text, code] = judged (request, answers)
  [text, code] = told ('judge', jsonencode (request), strjoin ([answers{:}], char (10)));
end

function [text, code] = told (varargin)
  [text, code] = library (varargin{:});
  if code == 2
    error ('tribocheck:argument', 'tribocheck_check: %s', text);
  end
end

% The answer to each question, as a line of JSON. Those at the end were asked before, and are asked once more.
function lines = answers_of (solver, name, questions, own, as_columns)
  ids = regexp (questions, '"id":("[^"]*")', 'tokens', 'once');
  ids = [ids{:}];
  count = numel (unique (ids));
  members = cell (1, numel (ids));
  [ask, columns] = way_to_ask (solver, name, questions, own);
  for part = {1:count, count + 1:numel(ids)}
    places = part{1};
    done = false;
    if as_columns && all (cellfun (@isnumeric, columns))
      try
        members(places) = members_of (ask (cellfun (@(one) one(places), columns, 'UniformOutput', false)), numel (places));
        done = true;
      catch
        % One by one it is told what is wrong.
      end
    end
    for place = places(1:end * ~done)
      try
        members(place) = members_of (ask (cellfun (@(one) one(place), columns, 'UniformOutput', false)), 1);
      catch problem
        members{place} = [', "error": ', jsonencode(problem.message)];
      end
    end
  end
  lines = strcat ('{"id": ', ids, members, '}');
end

% A function of columns that gives a struct of columns, [] for what is not offered, and the columns of all questions.
function [ask, columns] = way_to_ask (solver, name, questions, own)
  all = catalogue ();
  if ~isfield (all, name) || ischar (own.arguments)
    columns = {questions(:)};
    ask = @(given) as_struct (solver, {rmfield(jsondecode (given{1}{1}, 'makeValidName', false), 'id')}, {'value'}, struct ());
    return;
  end
  entry = all.(name);
  units = struct ();
  for one = [entry.parameters, entry.results]
    if isfield (own.units, one{1}.name)
      units.(one{1}.name) = unit_of (own.units, one{1});
    end
  end
  if iscell (own.arguments)
    wanted = own.arguments;
  else
    wanted = entry.arguments;
  end
  for k = 1:numel (wanted)
    known = find (strcmp (wanted{k}, entry.arguments));
    default = [];
    if ~isempty (known) && isfield (entry.parameters{known}, 'default')
      default = entry.parameters{known}.default;
    end
    columns{k} = column_of (wanted{k}, questions, default);
    if isfield (units, wanted{k})
      unit = units.(wanted{k});
      columns{k} = (columns{k} - unit(1)) / unit(2);
    end
  end
  ask = @(given) as_struct (solver, given, entry.fields, units);
end

% Zero and one of a unit, in the SI unit.
function unit = unit_of (units, quantity)
  text = units.(quantity.name);
  si = quantity.unit;
  if isempty (si)
    si = '%';
  end
  for k = 1:2
    [unit(k), code] = library ('number', sprintf ('%d %s', k - 1, text), si);
    if code ~= 0
      error ('tribocheck:argument', 'tribocheck_check: units: "%s" is no unit of %s; allowed: %s, or another unit of the same quantity', ...
             text, quantity.name, si);
    end
  end
  unit(2) = unit(2) - unit(1);
end

% An argument of all questions: numbers, or a cell of words. jsondecode would read numbers to some ulp only.
function column = column_of (name, questions, default)
  tokens = regexp (questions(:), ['"', name, '":("[^"]*"|[^,}]*)'], 'tokens', 'once');
  is_given = ~cellfun (@isempty, tokens);
  if isempty (default) && ~all (is_given)
    error ('tribocheck:argument', 'tribocheck_check: %s is no argument of the question; "arguments" has the names', name);
  end
  texts = cell (size (tokens));
  texts(is_given) = cellfun (@(one) one{1}, tokens(is_given), 'UniformOutput', false);
  if ischar (default) || ~isempty (texts{1}) && texts{1}(1) == '"'
    column = strrep (texts, '"', '');
    column(~is_given) = {default};
  else
    column = str2double (texts);
    column(~is_given) = default;
  end
end

% The results by their names, in SI units.
function found = as_struct (solver, given, results, units)
  given = cellfun (@plain, given, 'UniformOutput', false);
  count = numel (results);
  if count > 1 && nargout (solver) > 1
    [outputs{1:min (count, nargout (solver))}] = solver (given{:});
    found = cell2struct (outputs, results(1:numel (outputs)), 2);
  else
    found = solver (given{:});
  end
  if isempty (found)
    found = [];
    return;
  elseif ~isstruct (found)
    if count > 1
      error ('it gives %s, in place of a struct with %s', class (found), strjoin (results, ', '));
    end
    found = cell2struct ({found}, results, 2);
  end
  for name = fieldnames (found)'
    if isfield (units, name{1})
      unit = units.(name{1});
      found.(name{1}) = unit(1) + unit(2) * found.(name{1});
    end
  end
end

% A cell of one word is that word.
function value = plain (value)
  if iscellstr (value)
    value = value{1};
  end
end

% The members of each of `count` answers, as text.
function members = members_of (found, count)
  members = repmat ({''}, 1, count);
  if isempty (found)
    if count > 1
      error ('it gives nothing for columns');
    end
    members = {', "skip": "it gives []"'};
    return;
  end
  for name = fieldnames (found)'
    value = found.(name{1});
    if ischar (value)
      texts = {jsonencode(value)};
    elseif ~isnumeric (value) || numel (value) ~= count
      error ('%s is %s of the size %s, in place of a number', name{1}, class (value), mat2str (size (value)));
    elseif ~isreal (value)
      texts = arrayfun (@(one) ['"', num2str(one), '"'], value(:).', 'UniformOutput', false);
    else
      texts = arrayfun (@(one) sprintf ('%.17g', one), double (value(:).'), 'UniformOutput', false);
      texts = strrep (strrep (texts, 'Inf', 'Infinity'), 'NaN', 'null');
    end
    members = strcat (members, [', "', name{1}, '": '], texts);
  end
end
