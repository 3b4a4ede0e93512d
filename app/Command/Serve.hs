-- | @pra-tactile serve@: this library, or an impostor that is wrong in one way, as a subject of the
-- conformance suite, or of any program that asks it over JSON lines.
module Command.Serve
  ( command,
  )
where

import Data.Aeson (object, (.=))
import Data.Maybe (isJust)
import Data.String (fromString)
import ExitStatus
import Json
import Options
import PraTactile.Conformance.Impostors
import PraTactile.Conformance.Impostors.Killers
import PraTactile.Conformance.Library (library)
import PraTactile.Conformance.Serve
import System.IO (stdin, stdout)

data Options = Options
  { once :: Bool,
    impostor :: Maybe Impostor,
    listed :: Bool,
    form :: AnswerForm
  }

command :: Subcommand
command =
  subcommand
    "serve"
    "Answer the conformance protocol as a subject"
    "Answer requests of the conformance protocol, JSON lines on the standard input, until a stop \
    \request or the end of the input."
    []
    [ "echo '{\"command\": \"start\", \"protocol\": 1}' | pra-tactile serve",
      "pra-tactile conform --run field/multiplication-as-defined -- pra-tactile serve --impostor \
      \reduces-by-another-modulus",
      "pra-tactile serve --impostors"
    ]
    ( run
        <$> ( Options
                <$> switch (long "one-shot" <> help onceHelp)
                <*> optional (choosing "impostor" named "impostor" "NAME" impostorHelp mempty)
                <*> switch (long "impostors" <> help "List the impostors, and serve nothing")
                <*> jsonSwitch "List the impostors as JSON"
            )
    )
  where
    named = [(impostorName one, one) | one <- impostors]
    onceHelp = "Answer one request, which includes the profile"
    impostorHelp = "Be wrong in the way of this impostor, for the suite to find"

run :: Options -> IO ExitStatus
run options
  | listed options = do
    leaveOut
      "--impostors serves nothing"
      [("--one-shot", once options), ("--impostor", isJust (impostor options))]
    Answered <$ printAs (form options) text json
  | form options == AsJson = misused "--json is for --impostors; replies are JSON anyway"
  | otherwise = Answered <$ answer (maybe library impostorMade (impostor options)) stdin stdout
  where
    answer = if once options then serveOnce else serve
    text = concatMap listedText impostors
    json = encodeSchema "impostors/1" (fromString "impostors" .= map listedValue impostors)
    killers = killersOfProcess . impostorName
    listedText one =
      impostorName one ++ ": " ++ impostorMistake one ++ "\n    found by "
        ++ unwords (killers one)
        ++ "\n"
    listedValue one =
      object
        [ fromString "name" .= impostorName one,
          fromString "mistake" .= impostorMistake one,
          fromString "laws" .= killers one
        ]
