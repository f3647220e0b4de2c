function result = prehend_call (c, command, fields)
% PREHEND_CALL  Has prehend carry out a command of its protocol (docs/reference/protocol.md).
%   result = PREHEND_CALL (C, COMMAND) sends a command without fields over the connection C of
%   PREHEND_CONNECT and waits for what it replies.
%   result = PREHEND_CALL (C, COMMAND, FIELDS) sends the fields of a struct with it:
%
%     c = prehend_connect ();
%     prehend_call (c, 'object.set', struct ('generate', 'mug'));
%     pose = struct ('position', [0; 0; 0.2], 'quaternion_wxyz', [0; 1; 0; 0]);
%     prehend_call (c, 'hand.move', struct ('X_object_hand', pose));
%     grasp = prehend_call (c, 'hand.auto_grasp');
%
%   The result is as jsondecode makes it: lists of numbers are columns, null is [], and a list of
%   objects is a struct array where all have the same fields, else a cell array. The field "end" of
%   motions is called xEnd. A list of one number has to be a cell to be sent as a list; within
%   struct() that is {{0.5}}.
%
%   A refused command is an error whose id has the field that it is about: prehend:refused:dofs,
%   with '_' for what an id cannot contain (prehend:refused:X_world_hand_position), and
%   prehend:refused where it is about no field. Other ids: prehend:timeout, prehend:closed, and
%   prehend:fields where FIELDS is not one struct.
%
%   See also PREHEND_CONNECT, PREHEND_EVENTS.
  if nargin < 3
    fields = struct ();
  end
  if ~ isstruct (fields) || ~ isscalar (fields)
    error ('prehend:fields', 'fields must be one struct; a cell within struct() is {{...}}');
  end
  state = c.UserData;
  fields.id = state.next_id;
  fields.command = command;
  state.next_id = state.next_id + 1;
  c.UserData = state;
  send_line (c, jsonencode (fields));
  while true
    message = jsondecode (next_line (c));
    if isfield (message, 'event')
      state = c.UserData;
      state.events{end + 1} = message;
      c.UserData = state;
    elseif ~ isfield (message, 'id') || isempty (message.id) || isequal (message.id, fields.id)
      break;
    end  % else of a call that was given up
  end
  if ~ message.ok
    refuse (message.error);
  end
  result = message.result;
end

function refuse (problem)
  id = 'prehend:refused';
  words = problem.problem;
  if isfield (problem, 'value') && ~ isempty (problem.value)
    words = [words, ' (', problem.value, ')'];
  end
  if isfield (problem, 'field') && ~ isempty (problem.field)
    id = [id, ':', matlab.lang.makeValidName(problem.field)];
    words = [problem.field, ': ', words];
  end
  error (id, '%s', words);
end
