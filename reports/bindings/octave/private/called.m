% SPDX-License-Identifier: Apache-2.0

% The results of a function of the catalogue: an array, or a struct of arrays where it has several.
function answer = called (name, given)
  entry = catalogue ();
  entry = entry.(name);
  parameters = entry.parameters;
  names = entry.arguments;
  own = ['tribocheck_', name];
  if numel (given) > numel (names)
    error ('tribocheck:argument', '%s: too many arguments; it takes %s', own, strjoin (names, ', '));
  end
  for k = 1:numel (names)
    if k <= numel (given)
      columns{k} = column_of (own, parameters{k}, given{k});
    elseif isfield (parameters{k}, 'default')
      columns{k} = column_of (own, parameters{k}, parameters{k}.default);
    else
      error ('tribocheck:argument', '%s: %s is missing', own, names{k});
    end
  end
  [columns, shape] = spread (own, names, columns);
  count = numel (entry.fields);
  [fault, place, values{1:count}] = library ('call', name, columns{:});
  if ~isempty (fault)
    error ('tribocheck:argument', '%s: %s%s', own, place_text (place, shape), fault);
  elseif count == 1
    answer = values{1};
  else
    answer = cell2struct (values, entry.fields, 2);
  end
end

% An argument as numbers; words are their codes.
function column = column_of (own, parameter, given)
  if isfield (parameter, 'words')
    if ~ischar (given) && ~iscellstr (given)
      error ('tribocheck:argument', '%s: %s is no text, nor a cell of texts', own, parameter.name);
    end
    given = cellstr (given);
    [is_known, code] = ismember (given, parameter.words);
    if ~all (is_known(:))
      error ('tribocheck:argument', '%s: %s: "%s" is not known; allowed: %s', own, parameter.name, given{find (~is_known, 1)}, ...
             strjoin (parameter.words(:)', ', '));
    end
    column = code - 1;
  elseif isnumeric (given) && isreal (given)
    column = full (double (given));
  else
    kinds = {'', 'complex '};
    error ('tribocheck:argument', '%s: %s is %s%s, in place of real numbers', own, parameter.name, kinds{1 + isnumeric (given)}, class (given));
  end
end

% Gives all arrays the same shape, as Octave's own operators do.
function [columns, shape] = spread (own, names, columns)
  shape = [1, 1];
  is_array = cellfun (@numel, columns) ~= 1;
  for column = columns(is_array)
    shape(end + 1:ndims (column{1})) = 1;
    extent = extent_of (column{1}, shape);
    if any (extent ~= shape & extent ~= 1 & shape ~= 1)
      texts = cellfun (@(name, one) [name, ' ', strjoin(arrayfun (@num2str, size (one), 'UniformOutput', false), 'x')], ...
                       names(is_array), columns(is_array), 'UniformOutput', false);
      error ('tribocheck:argument', '%s: shapes that do not go together: %s', own, strjoin (texts, ', '));
    end
    shape(shape == 1) = extent(shape == 1);
  end
  for k = find (is_array)
    times = shape;
    times(extent_of (columns{k}, shape) == shape) = 1;
    if any (times ~= 1)
      columns{k} = repmat (columns{k}, times);
    end
  end
end

function extent = extent_of (array, shape)
  extent = size (array);
  extent(end + 1:numel (shape)) = 1;
end

% The place of a point: "at index 17: ", "at index (2, 3): ", or nothing where it is the only one.
function text = place_text (place, shape)
  if all (shape == 1)
    text = '';
  elseif numel (shape) == 2 && any (shape == 1)
    text = sprintf ('at index %d: ', place);
  else
    [index{1:numel (shape)}] = ind2sub (shape, place);
    text = sprintf ('at index (%s): ', strjoin (cellfun (@num2str, index, 'UniformOutput', false), ', '));
  end
end
