% SPDX-License-Identifier: Apache-2.0

% The functions of the catalogue by name, with parameters, results and the names of both as rows of cells.
function all = catalogue ()
  persistent kept
  if isempty (kept)
    document = jsondecode (library ('describe'));
    for one = listed (document.functions)
      entry = one{1};
      entry.parameters = listed (entry.parameters);
      entry.results = listed (entry.results);
      entry.arguments = cellfun (@(one) one.name, entry.parameters, 'UniformOutput', false);
      entry.fields = cellfun (@(one) one.name, entry.results, 'UniformOutput', false);
      kept.(entry.name) = entry;
    end
  end
  all = kept;
end

% jsondecode makes structs with the same fields an array.
function cells = listed (entries)
  if isstruct (entries)
    entries = num2cell (entries);
  end
  cells = entries(:)';
end
