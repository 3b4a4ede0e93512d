{-# OPTIONS_GHC -O1 #-}

-- | Where a grid of symbols is, and how doubtful that is: the posterior of
-- docs/explanation/locating.md, summed by brute force over all positions, both ways up, and the
-- share of foreign things.
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
    it "a grid is where that is likeliest, with the doubt that is left, or it is nowhere" $
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

-- | What was read.
data Seen = Seen
  { -- | by cells along the symbols' axes
    seenCells :: Cells,
    -- | off their grid
    seenStrays :: [ReadSymbol],
    -- | along the other axis
    seenDissenters :: [ReadSymbol]
  }

-- | That it is the array's, lies that way up, and begins at that position; with the product of the
-- probabilities of what the array then has in the observed cells, of those that say nothing 30
-- times the least of all, at most their mean, and of how probable it is beforehand.
data Hypothesis = Hypothesis
  { wayUp :: Symmetry,
    beginning :: Position,
    likelihood :: Double,
    silent :: [(Int, Int)]
  }

-- | All that are possible, likely or not, where these faces are laid. Beforehand each is as
-- probable as any other by which one face has all cells that the network knows, and then cells
-- beyond that face say nothing; and 200 times as probable as any by which none has.
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

-- | The cells of which the symbols read there say something.
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

-- | Where a cell is on a face that is seen that way up.
onFace :: Cells -> Symmetry -> (Int, Int) -> (Int, Int)
onFace cells o (i, j)
  | o `elem` [turned 2, turned 3] = (furthest fst - i, furthest snd - j)
  | otherwise = (i, j)
  where
    furthest part = maximum (map part (Map.keys cells))

-- | How probable what was read in a cell makes this symbol, that way up: independent looks.
chance :: Symmetry -> Int -> [ReadSymbol] -> Double
chance o c here = product [sum [p | (what, p) <- readChances s, what == (o, c)] | s <- here]

-- | How probable it is that it is foreign by chance, if it is not another array, given the share of
-- foreign things, and of the likeliest hypothesis how probable that is among those of the array;
-- and how many times as probable it is that it is one of some other arrays. Of what is foreign by
-- chance either way up is as likely, and there each symbol in each cell; of what is the array's one
-- cell in a hundred is like that.
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

-- | What is certain of a symbol: what the network knows where that is likeliest and less than a
-- tenth is in doubt, and of a third of a symbol at least, where less than a thousandth is.
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

-- | What is located, given what is tolerated, against the hypotheses. Of other arrays a bound is
-- told, which is taken as it is; where they are given, they are added up and must not exceed it.
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
            counterexample "other arrays are no likelier than is told" $
              maybe True ((<= alien * (1 + 1e-6) + 1e-9) . summed) others,
            told doubtOfStitching === 0,
            counterexample "as far as tolerated" $
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
      -- A complete one must be among those that agree.
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
    -- The doubt as it was told; what it should be is a law of its own.
    doubt = maybe 1 supportDoubt (locationSupport found)
    told part = maybe (-1) (part . supportDoubts) (locationSupport found)

isPlaced :: GridLocation -> Bool
isPlaced found = case locationOutcome found of
  Placed _ -> True
  _ -> False

near :: Double -> Double -> Property
near a b = counterexample (show (a, b)) (abs (a - b) <= 1e-9 + 1e-6 * abs b)
