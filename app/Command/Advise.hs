-- | @pra-tactile advise@: which arrays exist, which do not and why, and what to do instead.
module Command.Advise
  ( command,
  )
where

import ExitStatus
import Message.Advice
import Options
import PraTactile.Advise
import PraTactile.Format (encodeAdvice)

command :: Subcommand
command =
  subcommand
    "advise"
    "List which arrays of at least a given size exist"
    "List the arrays with at least so many rows and columns, the smallest first: which exist, and \
    \which do not and why. The status is 1 if none exists."
    []
    [ "pra-tactile advise --rows 30 --columns 40 --q 4",
      "pra-tactile advise --rows 15 --columns 273 --q 4 --window 2x3"
    ]
    ( run
        <$> ( Request
                <$> orderOption
                <*> least "rows"
                <*> least "columns"
                <*> optional
                  (valued shapeReader "window" "ROWSxCOLUMNS" "Shape of the window (default: any)")
            )
        <*> jsonSwitch "Print the advice as JSON"
    )
  where
    least name = valued naturalReader name "NUMBER" ("At least this many " ++ name)

run :: Request -> AnswerForm -> IO ExitStatus
run request form = do
  advice <- orUnusable adviceErrorMessage (advise request)
  printAs
    form
    (unlines (adviceLines request advice))
    (encodeAdvice obstacleMessage request advice)
  pure (if null (adviceOptions advice) then NotAnswered else Answered)
