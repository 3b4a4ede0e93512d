-- | @pra-tactile serve@: this library as a subject of the conformance suite, or of any program that
-- asks it over JSON lines.
module Command.Serve
  ( command,
  )
where

import ExitStatus
import Options
import PraTactile.Conformance.Library (library)
import PraTactile.Conformance.Serve
import System.IO (stdin, stdout)

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "serve"
    "Answer the requests of the conformance protocol, JSON lines on the standard input, until stop \
    \or the end of the input."
    [ "echo '{\"command\": \"start\", \"protocol\": 1}' | pra-tactile serve",
      "pra-tactile conform --stage field -- pra-tactile serve"
    ]
    ( run
        <$> switch (long "one-shot" <> help "Answer one request, which has the profile as well")
    )

run :: Bool -> IO ExitStatus
run once = do
  (if once then serveOnce else serve) library stdin stdout
  pure Answered
