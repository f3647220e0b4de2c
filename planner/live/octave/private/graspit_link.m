function link = graspit_link (new)
% The connection that the functions of GraspIt!'s protocol use; with an argument it becomes this.
  persistent current
  if nargin > 0
    current = new;
  end
  if isempty (current)
    error ('graspit:connect', 'no connection: call graspit_connect first');
  end
  link = current;
end
