-- | @pra-tactile advise@: which arrays there are, which there are not and why, and what to do
-- instead.
module Command.Advise
  ( command,
  )
where

import ArrayChoice
import qualified Data.ByteString.Char8 as Bytes
import Described
import Ending
import Message.Advice
import Numeric.Natural (Natural)
import Options.Applicative hiding (command)
import PraTactile.Advise
import PraTactile.Array (Shape)
import PraTactile.Format (encodeAdvice)

command :: Mod CommandFields (IO Ending)
command =
  described
    "advise"
    "List the arrays of at least so many rows and columns: what is possible, what is not and why, \
    \in order of size; status 1 if nothing is."
    [ "pra-tactile advise --rows 30 --columns 40 --q 4",
      "pra-tactile advise --rows 15 --columns 273 --q 4 --window 2x3"
    ]
    ( run
        <$> orderOption
        <*> least "rows"
        <*> least "columns"
        <*> window
        <*> switch (long "json" <> help "Print the advice as JSON")
    )
  where
    least name =
      option naturalReader (long name <> metavar "NUMBER" <> help ("Least number of " ++ name))
    window =
      optional
        ( option
            shapeReader
            (long "window" <> metavar "ROWSxCOLUMNS" <> help "Shape of the window (default: any)")
        )

run :: Natural -> Natural -> Natural -> Maybe Shape -> Bool -> IO Ending
run q high wide window asJson = do
  let request = Request q high wide window
  advice <- orUnusable adviceErrorMessage (advise request)
  if asJson
    then Bytes.putStrLn (encodeAdvice obstacleMessage request advice)
    else putStr (unlines (adviceLines request advice))
  pure (if null (adviceOptions advice) then NotAnswered else Answered)
