-- | @pra-tactile profile@: the conventions in force, as JSON.
module Command.Profile
  ( command,
  )
where

import ArrayChoice
import ExitStatus
import Message (profileMessage)
import Options
import PraTactile.Format.Profile
import PraTactile.Profile (withProfile)

command :: Subcommand
command =
  subcommand
    "profile"
    "Print every convention of an array, as JSON"
    "Print the profile of an array as JSON: every convention on which implementations must agree."
    [arrayGroup]
    [ "pra-tactile profile",
      "pra-tactile profile --q 2 --polynomial 1,1,0,0,1 --shape 3x5 > mine.json && pra-tactile \
      \array --profile mine.json"
    ]
    (run <$> arrayChoice)

run :: ArrayChoice -> IO ExitStatus
run choice = do
  profile <- chosenProfile choice
  orUnusable profileMessage (withProfile profile (\_ _ -> ()))
  putStrLn (profileText profile)
  pure Answered
