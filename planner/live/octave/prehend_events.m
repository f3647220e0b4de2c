function events = prehend_events (c, seconds)
% PREHEND_EVENTS  The events of a live session of prehend (docs/reference/protocol.md).
%   events = PREHEND_EVENTS (C) is a cell array of the events that have come over the connection C
%   since they were asked for last, in their order, each a struct whose field 'event' says what it
%   is.
%   events = PREHEND_EVENTS (C, SECONDS) waits for one, at most so long, where none has come.
%
%     prehend_call (c, 'plan.start', struct ('trials', 100));
%     ended = false;
%     while ~ ended
%       ended = any (cellfun (@(e) strcmp (e.event, 'plan'), prehend_events (c, 1)));
%     end
%     best = prehend_call (c, 'plan.results', struct ('count', 1));
%
%   See also PREHEND_CALL.
  if nargin < 2
    seconds = 0;
  end
  begun = tic ();
  while true
    while any (c.UserData.unread == 10) || c.NumBytesAvailable > 0
      message = jsondecode (next_line (c));
      if isfield (message, 'event')
        state = c.UserData;
        state.events{end + 1} = message;
        c.UserData = state;
      end
    end
    if ~ isempty (c.UserData.events) || toc (begun) >= seconds
      break;
    end
    pause (0.01);
  end
  state = c.UserData;
  events = state.events;
  state.events = {};
  c.UserData = state;
end
