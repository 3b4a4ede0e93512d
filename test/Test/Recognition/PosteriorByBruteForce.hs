{-# OPTIONS_GHC -O1 #-}

-- | The place of a grid of symbols and its doubt: the posterior of docs/explanation/locating.md,
-- summed by brute force over all positions, both ways up, and the prior of foreign surfaces.
module Test.Recognition.PosteriorByBruteForce (spec) where

import Data.List (maximumBy, nub)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust, isNothing)
import Data.Ord (comparing)
import PraTactile.Array
import PraTactile.Locate (Radius (..))
import PraTactile.Object.Placement
import PraTactile.Recognise
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.GridLocation
import PraTactile.Recognise.GridOutcome
import PraTactile.Symmetry
import Test.Code.Locate.OtherPolynomials
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck hiding (tolerance, total)
import Test.Recognition.Scenes

spec :: Spec
spec = onRecognisers $ \array readers ->
  withCases 20 400 $
    it "a grid is placed at its likeliest position with the remaining doubt, or not placed" $
      forAllBlind (elements readers) $ \(surface, reader) -> do
        let scenes = genScene (cellOf surface array)
        scene <- scenes [1e-7, 0.0005, 0.01, 0.09, 0.2, 0.8]
        others <- concat . Map.elems . sceneCells <$> scenes [1e-7, 0.05, 0.2]
        radius <- elements [Guaranteed, UpTo 0, UpTo 1, UpTo 2]
        tolerated <- elements [0.01, 0.3, 0.9]
        share <- elements [0, 0.005, 0.3]
        apart <- elements [0, 0, 1, 2, 3]
        whole <- frequency [(1, pure True), (9, pure False)]
        let (strays, dissenters) = splitAt (apart `div` 2) (take apart others)
            seen = Seen (scattered scene) strays dissenters
        pure $
          judged
            (laidFaces (recogniserPlacement reader))
            (cellOf surface array)
            (if whole then Just (map (cellOf surface) (byOtherPolynomials array)) else Nothing)
            ( \limits ->
                locateGrid reader limits dissenters (FaceGrid (seenCells seen) [] strays (0, 0))
            )
            (Tolerance tolerated radius share Nothing 0)
            seen

-- | The symbols that were read.
data Seen = Seen
  { -- | by cells along the symbols' axes
    seenCells :: Cells,
    -- | off their grid
    seenStrays :: [ReadSymbol],
    -- | along the other axis
    seenDissenters :: [ReadSymbol]
  }

-- | The hypothesis that the symbols are the array's, lie this way up, and begin at this position.
-- Its likelihood is the product of the prior and of the probabilities of the array's symbols in the
-- observed cells. A silent cell has 30 times the least probability of all, but at most their mean.
data Hypothesis = Hypothesis
  { wayUp :: Symmetry,
    beginning :: Position,
    likelihood :: Double,
    silent :: [(Int, Int)]
  }

-- | All possible hypotheses, likely or not, on these laid faces. Two hypotheses have equal priors
-- if in each a face has all cells that the network knows; cells beyond that face are then silent.
-- Without such a face the prior is 200 times smaller.
hypotheses :: [LaidFace] -> OnArray -> Cells -> [Hypothesis]
hypotheses faces onArray cells =
  [ Hypothesis o place (prior * product (zipWith said (observed cells) codes)) beyond
    | o <- waysUp cells,
      place <- Position <$> [0 .. 14] <*> [0 .. 16],
      Just codes <- [traverse (fmap snd . onArray place . onFace cells o . fst) (observed cells)],
      let under =
            [ off
              | first' : _ <- [known],
                Just (at, _) <- [onArray place (onFace cells o first')],
                laid <- faces,
                cell <- blockCells (laidBlock laid),
                onBoth (+) (laidAt laid) cell == at,
                let off = filter (not . hasCell' laid . from first' cell o) (Map.keys cells),
                all (`notElem` off) known
            ]
          (prior, beyond) = case under of
            off : _ -> (1, off)
            [] -> (if null faces || null known then 1 else 0.005, [])
          said (at, here) code
            | at `elem` beyond =
              let every = [chance o' c here | o' <- waysUp cells, c <- [0 .. 3]]
               in min (30 * minimum every) (sum every / 8)
            | otherwise = chance o code here
  ]
  where
    known = [at | (at, here) <- Map.toList cells, any (isJust . readClass) here]
    onBoth f (Position r c) (Position r' c') = Position (f r r') (f c c')
    hasCell' laid (r, c) =
      r >= 0
        && c >= 0
        && Position (fromIntegral r) (fromIntegral c) `elem` blockCells (laidBlock laid)
    -- A cell's row and column in the block where the first one has these.
    from first' (Position r c) o at =
      let ((i0, j0), (i, j)) = (onFace cells o first', onFace cells o at)
       in (fromIntegral r + i - i0, fromIntegral c + j - j0) :: (Int, Int)

-- | The cells whose symbols have any probability.
observed :: Cells -> [((Int, Int), [ReadSymbol])]
observed cells =
  [ (at, here)
    | (at, here) <- Map.toList cells,
      or [chance o c here > 0 | o <- waysUp cells, c <- [0 .. 3]]
  ]

-- | The two ways up of the symbols' axis.
waysUp :: Cells -> [Symmetry]
waysUp cells
  | any sideways (concat (Map.elems cells)) = [turned 1, turned 3]
  | otherwise = [identity, turned 2]
  where
    sideways = exchangesAxes . fst . readLikeliest

-- | The place of a cell on a face that is seen this way up.
onFace :: Cells -> Symmetry -> (Int, Int) -> (Int, Int)
onFace cells o (i, j)
  | o `elem` [turned 2, turned 3] = (furthest fst - i, furthest snd - j)
  | otherwise = (i, j)
  where
    furthest part = maximum (map part (Map.keys cells))

-- | The probability of a cell's readings, which are independent, given this symbol and way up.
chance :: Symmetry -> Int -> [ReadSymbol] -> Double
chance o c here = product [sum [p | (what, p) <- readChances s, what == (o, c)] | s <- here]

-- | For surfaces other than this array: a function from other arrays to the odds of these against
-- chance and this array together, and the probability of chance without other arrays. Given are the
-- prior of foreign surfaces and the likeliest hypothesis. By chance both ways up and all symbols
-- are equally likely in each cell, and so is one cell in a hundred of the array.
foreignBy ::
  Double -> OnArray -> Cells -> [Hypothesis] -> Hypothesis -> ([OnArray] -> Double, Double)
foreignBy share onArray cells every best
  | share <= 0 = (const 0, 0)
  | otherwise = (\others -> alien others / theirs, theirs / (theirs + ours))
  where
    count = length every
    probability = likelihood best / sum (map likelihood every)
    alien others =
      share / 2 / fromIntegral count
        * sum [likelihood one' | other <- others, one' <- hypotheses [] other speaking]
        / fromIntegral (length others)
    theirs = share / 4 * sum [product (map (anyOf o . snd) known) | o <- waysUp cells]
    ours = (1 - share) / fromIntegral count * product (map mixed known) / probability
    -- They are cells of the same grid.
    speaking = Map.mapWithKey (\at here -> if at `elem` silent best then [] else here) cells
    known = observed speaking
    anyOf o here = sum [chance o c here | c <- [0 .. 3]] / 4
    mixed (at, here) =
      0.99 * maybe 0 (\(_, c) -> chance (wayUp best) c here) (there at)
        + 0.01 * anyOf (wayUp best) here
    there = onArray (beginning best) . onFace cells (wayUp best)

-- | The certain reading of a symbol: what the network knows, if it is the likeliest and its doubt
-- is below a tenth; or the likeliest, if at least a third of the symbol was seen and the doubt is
-- below a thousandth.
certainly :: ReadSymbol -> Maybe (Symmetry, Int)
certainly s
  | readSeen s >= 1 =
    if doubt < 0.1 && readClass s == Just likeliest then Just likeliest else Nothing
  | readSeen s >= 1 / 3 && doubt < 0.001 = Just likeliest
  | otherwise = Nothing
  where
    likeliest = readLikeliest s
    doubt = sum [p | (what, p) <- readChances s, what /= likeliest]

-- | The least number of these cells that are not zero anywhere on the torus: the code is linear.
distanceOf :: (Position -> (Int, Int) -> Int) -> [(Int, Int)] -> Int
distanceOf codeAt cells =
  minimum
    [ length (filter ((/= 0) . codeAt place) cells)
      | place <- Position <$> [0 .. 14] <*> [0 .. 16]
    ]

-- | Compares a location, for what is tolerated, with the hypotheses. The reported bound for other
-- arrays is taken as it is. If the arrays are given, their sum must not exceed it.
judged ::
  [LaidFace] ->
  OnArray ->
  Maybe [OnArray] ->
  (Tolerance -> GridLocation) ->
  Tolerance ->
  Seen ->
  Property
judged faces onArray others locating tolerance seen = case hypotheses faces onArray cells of
  every
    | null (observed cells) || total every <= 0 ->
      label "nowhere" (isNothing (locationSupport found) && not (isPlaced found))
    | length (filter ((> 0.999 * likelihood best) . likelihood) every) > 1 -> label "tied" True
    | otherwise ->
      label (if isPlaced found then "placed" else "not placed") $
        conjoin
          [ locationOrientation found === wayUp best,
            near (told doubtOfPosition) (elsewhere' * (1 - random - alien)),
            near (told (doubtOfRandom . doubtsOfOrigin)) random,
            counterexample "other arrays are likelier than reported" $
              maybe True ((<= alien * (1 + 1e-6) + 1e-9) . summed) others,
            told doubtOfStitching === 0,
            counterexample "placed exactly if tolerated" $
              show (locationOutcome found)
                === if doubt <= toleratedDoubt tolerance && fitting
                  then show (Placed (beginning best))
                  else show (locationOutcome found),
            isPlaced found === (doubt <= toleratedDoubt tolerance && fitting),
            isPlaced (upTo doubt) === fitting,
            isPlaced (upTo (doubt * 0.999)) === False
          ]
    where
      best = maximumBy (comparing likelihood) every
      total = sum . map likelihood
      elsewhere' = (total every - likelihood best) / total every
      (times, alone) = foreignBy (foreignPrior tolerance) onArray cells every best
      alien = told (doubtOfOtherArrays . doubtsOfOrigin)
      summed some = times some * alone / (1 + times some * alone)
      random = alone * (1 - alien)
      there = onFace cells (wayUp best)
      certain' = [(at, what) | (at, here) <- heard, Just what <- map certainly here]
      heard = filter ((`notElem` silent best) . fst) (Map.toList cells)
      agrees (at, (o, c)) =
        o == wayUp best && fmap snd (onArray (beginning best) (there at)) == Just c
      beside = filter (isJust . certainly) (seenStrays seen ++ seenDissenters seen)
      wrong = length (filter (not . agrees) certain') + length beside
      own = nub [there at | (at, (o, _)) <- certain', o == wayUp best]
      -- A complete symbol must be among those that agree.
      fitting =
        wrong <= radius
          && or
            [ readSeen s >= 1 && agrees (at, what)
              | (at, here) <- heard,
                s <- here,
                Just what <- [certainly s]
            ]
      radius = case toleratedErrors tolerance of
        UpTo n -> fromIntegral n
        Guaranteed -> max 0 ((distanceOf torus own - 1) `div` 2)
      torus (Position r c) (i, j) =
        let at = Position ((r + fromIntegral i) `mod` 15) ((c + fromIntegral j) `mod` 17)
         in maybe 0 snd (onArray at (0, 0))
  where
    cells = seenCells seen
    found = locating tolerance
    upTo limit = locating tolerance {toleratedDoubt = limit}
    -- The doubt as reported; its value is the subject of another law.
    doubt = maybe 1 supportDoubt (locationSupport found)
    told part = maybe (-1) (part . supportDoubts) (locationSupport found)

isPlaced :: GridLocation -> Bool
isPlaced found = case locationOutcome found of
  Placed _ -> True
  _ -> False

near :: Double -> Double -> Property
near a b = counterexample (show (a, b)) (abs (a - b) <= 1e-9 + 1e-6 * abs b)
