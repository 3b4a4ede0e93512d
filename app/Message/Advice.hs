-- | The adviser's answers in words.
module Message.Advice
  ( adviceErrorMessage,
    adviceLines,
    obstacleMessage,
  )
where

import Data.List (intercalate)
import Json (shapeText, surfaceName)
import Message.Code (factorMessage, fieldMessage, numeral, windowMessage)
import PraTactile.Advise
import PraTactile.Array
import PraTactile.Window (WindowError (..))

adviceErrorMessage :: AdviceError -> String
adviceErrorMessage e = case e of
  AdviceField why -> fieldMessage why
  AdviceWindowEmpty -> windowMessage WindowEmpty
  AdviceWindowTooLarge cells -> windowMessage (WindowTooLarge cells)
  AdviceTooLarge cells -> numeral cells ++ " cells are wanted; the adviser goes up to 2^128"

-- | The possible arrays, the impossible ones, and a command to try next.
adviceLines :: Request -> Advice -> [String]
adviceLines request (Advice options obstacles) = possible ++ impossible ++ next
  where
    possible = case options of
      [] -> ["Nothing is possible."]
      _ ->
        "Possible, the smallest first:" :
        map ("  " ++) (someOf 24 (map (pure . optionLine) options))
    impossible =
      if null obstacles
        then []
        else "Not possible:" : map ("  " ++) (someOf 12 (map obstacleLines obstacles))
    next =
      take
        1
        [ "For example: " ++ commandFor request option fit
          | option <- options,
            Single _ <- [optionLayout option],
            fit <- optionFits option
        ]

-- | The first entries, and how many more there are.
someOf :: Int -> [[String]] -> [String]
someOf limit entries =
  concat (take limit entries) ++ ["and " ++ show more ++ " more, which --json lists" | more > 0]
  where
    more = length entries - limit

obstacleLines :: Obstacle -> [String]
obstacleLines obstacle =
  obstacleMessage obstacle : case obstacle of
    SidesShareDivisor _ _ _ _ repairs -> ["  instead: " ++ optionLine option | option <- repairs]
    _ -> []

optionLine :: Option -> String
optionLine option =
  shapeText (optionShape option)
    ++ ", "
    ++ arrangement (optionLayout option)
    ++ ", degree "
    ++ show (optionDegree option)
    ++ ": windows "
    ++ windows
    ++ neighbours
    ++ concat ["; its own mirror, " ++ exchanged mirror | mirror <- optionMirrors option]
  where
    exchanged mirror = case mirror of
      ColumnsMirrored -> "left and right exchanged"
      RowsMirrored -> "up and down exchanged"
    neighbours = case (optionColumnsToCheck option, optionRowsToCheck option) of
      (Just wide, Just high) ->
        "; " ++ show wide ++ " adjacent columns or " ++ show high ++ " rows check each other"
      (Just wide, Nothing) -> "; " ++ show wide ++ " adjacent columns check each other"
      (Nothing, Just high) -> "; " ++ show high ++ " adjacent rows check each other"
      (Nothing, Nothing) -> ""
    windows =
      intercalate
        "; "
        ( [ intercalate ", " [shapeText (fitWindow f) | f <- sure]
              ++ " with every primitive polynomial"
            | not (null sure)
          ]
            ++ [ shapeText (fitWindow f) ++ " with " ++ polynomialText f
                 | f <- optionFits option,
                   not (fitEvery f)
               ]
        )
    sure = filter fitEvery (optionFits option)

polynomialText :: Fit -> String
polynomialText = intercalate "," . map show . fitPolynomial

arrangement :: Layout -> String
arrangement layout = case layout of
  Single Diagonal -> "one array on the torus"
  Single RowMajor -> "one array row by row on the twisted torus"
  Joint g -> show g ++ " arrays on tori of their own that share the windows"

obstacleMessage :: Obstacle -> String
obstacleMessage obstacle =
  "degree " ++ show (obstacleDegree obstacle) ++ ": " ++ case obstacle of
    NoSuchShape _ terms -> show terms ++ " cells make no shape with so many rows and columns"
    SidesShareDivisor _ n1 n2 g _ ->
      shapeText (Shape n1 n2) ++ " on the torus: both sides are divisible by " ++ show g
        ++ ", so the diagonal closes after "
        ++ show (lcm n1 n2)
        ++ " of "
        ++ show (n1 * n2)
        ++ " cells, and no linear array of this size exists there"
    WindowTooFewCells n w ->
      "a window of "
        ++ shapeText w
        ++ " has "
        ++ show (area w)
        ++ " cells; "
        ++ show n
        ++ " are needed to tell all positions apart"
    WindowBeyondArray _ layout shape ->
      shapeText shape ++ ", " ++ arrangement layout ++ ": the window is larger than the array"
    WindowFails _ layout shape tried ->
      shapeText shape
        ++ ", "
        ++ arrangement layout
        ++ ": the windows repeat on the "
        ++ surfaceName (layoutSurface layout)
        ++ " with each of the first "
        ++ show tried
        ++ " primitive polynomials"
    NotFactored n why -> "q^" ++ show n ++ " - 1 was not factored: " ++ factorMessage why

-- | The command that proves an option with one array.
commandFor :: Request -> Option -> Fit -> String
commandFor request option fit =
  unwords
    ( [ "pra-tactile prove --q",
        show (requestOrder request),
        "--polynomial",
        polynomialText fit,
        "--shape",
        shapeText (optionShape option),
        "--window",
        shapeText (fitWindow fit)
      ]
        ++ ["--folding row-major" | Single RowMajor <- [optionLayout option]]
    )
