function [id, words] = error_id_of (call)
% The id and the words of the error that a call ends with, empty where it does not.
  id = '';
  words = '';
  try
    call ();
  catch problem
    id = problem.identifier;
    words = problem.message;
  end
end
