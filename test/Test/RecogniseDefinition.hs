-- | Where a grid of symbols is, and what is found there, stated once more from the definitions and
-- compared at grids with symbols that are wrong, unsure, upside down, missing, or in doubt.
module Test.RecogniseDefinition (spec) where

import Data.Function (on)
import Data.List (maximumBy, nub, partition, sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust, listToMaybe, mapMaybe)
import Data.Ord (comparing)
import qualified Data.Set as Set
import PraTactile.Array
import PraTactile.Classification.Network.File (shippedNetwork)
import PraTactile.Field (KnownField, toCode)
import PraTactile.Locate (Chance (..), Outcome (..), Radius (..), Reason (..), locate, onePatch)
import qualified PraTactile.Locate as Locate
import PraTactile.Locate.Decoder.Codebook (codebookArray, codebookSurface, observedDistance)
import PraTactile.Object.Canonical (canonicalPlacement)
import PraTactile.Object.Placement
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.Finding
import PraTactile.Recognise.GridLocation
import PraTactile.Recognise.Recogniser
import PraTactile.Recognise.SymbolBelief
import PraTactile.Shape (paperAlphabet)
import PraTactile.Symbol (elementOfClass)
import PraTactile.Symmetry
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (classes, generate, reason, tolerance, total)
import Test.RecognisedSymbols

spec :: Spec
spec = either (it "the shipped parts fit together" . expectationFailure) id $ do
  layout <- shown canonicalPlacement
  net <- shown shippedNetwork
  known <- shown paperAlphabet
  shown $
    withProfile canonicalProfile $ \array mask ->
      case mapM (\surface -> recogniser surface array mask layout known net) [Torus, Sheet] of
        Right readers -> do
          modifyMaxSuccess (const 400) (locatedSpec readers)
          modifyMaxSuccess (const 200) (foundSpec readers)
        Left e -> it "the array has a recogniser" (expectationFailure (show e))
  where
    shown :: Show e => Either e a -> Either String a
    shown = either (Left . show) Right

-- | A grid of symbols as the array has them from a position on, seen in an orientation, with
-- damage; some cells have none, some two.
data Scene = Scene
  { sceneOrientation :: Symmetry,
    scenePosition :: Position,
    -- | as they lie on the face
    sceneCells :: Cells
  }

-- | What the array has in a cell of a grid whose first cell is at a position, and where that is.
cellOf :: KnownField k => Recogniser k -> Position -> (Int, Int) -> Maybe (Position, Int)
cellOf reader (Position r c) (i, j)
  | inside || codebookSurface (recogniserCodebook reader) == Torus = Just (place, code)
  | otherwise = Nothing
  where
    (down, across) = (fromIntegral r + i, fromIntegral c + j)
    inside = down >= 0 && down < 15 && across >= 0 && across < 17
    place = Position (fromIntegral (down `mod` 15)) (fromIntegral (across `mod` 17))
    code = toCode (cellAt (codebookArray (recogniserCodebook reader)) place)

genScene :: KnownField k => Recogniser k -> [Double] -> Gen Scene
genScene reader doubts = do
  orientation <- elements rotations
  position <- Position <$> elements [0 .. 14] <*> elements [0 .. 16]
  (high, wide) <- elements [(1, 1), (2, 2), (2, 3), (3, 3), (1, 5), (3, 4)]
  wrong <- frequency [(3, pure 0), (2, choose (0, 0.4))]
  gaps <- frequency [(3, pure 0), (1, choose (0, 0.7))]
  unknown <- frequency [(5, pure (1 / 6)), (1, pure 1)]
  let cells = [(i, j) | i <- [0 .. high - 1], j <- [0 .. wide - 1]] :: [(Int, Int)]
  here <- traverse (symbolsIn orientation position (wrong, unknown) gaps) cells
  let drawn = concat (zipWith (\cell -> map ((,) cell)) cells here)
      numbered = zipWith (\n (cell, s) -> (cell, [s {readNumber = n}])) [0 ..] drawn
  pure (Scene orientation position (Map.fromListWith (flip (++)) numbered))
  where
    symbolsIn orientation position wrong gaps cell = do
      empty <- chance gaps
      count <- if empty then pure 0 else frequency [(6, pure 1), (1, pure 2)]
      vectorOf count (symbolIn orientation position wrong cell)
    symbolIn orientation position (wrong, unknown) (i, j) = do
      spoilt <- chance wrong
      about <- chance (wrong / 3)
      other <- choose (0, 3)
      doubt <- elements doubts
      known <- not <$> chance unknown
      source <- choose (0, 2)
      seen <- frequency [(8, pure 1), (1, pure (1 / 3)), (1, pure 0.3)]
      jitter <- (,) <$> choose (-1, 1) <*> choose (-1, 1)
      let true = maybe other snd (cellOf reader position (i, j))
          class' = if spoilt then other else true
          way = if about then orientation <> turned 2 else orientation
          rest = [(o, c) | o <- [way, way <> turned 2], c <- [0 .. 3], (o, c) /= (way, class')]
          (x, y) = onOffset orientation (16 * fromIntegral j, 20 * fromIntegral i)
      pure
        (symbolOf 0 (x + fst jitter + 50, y + snd jitter - 9) (way, class'))
          { readSource = source,
            readClass = if known && seen == 1 then Just (way, class') else Nothing,
            readSeen = seen,
            readChances = ((way, class'), 1 - doubt) : [(what, doubt / 7) | what <- rest]
          }
    chance p = (< p) <$> choose (0, 1 :: Double)

locatedSpec :: KnownField k => [Recogniser k] -> Spec
locatedSpec readers =
  it "a grid is where its probabilities have it, against no more certain symbols than its radius" $
    forAllBlind (elements readers) $ \reader ->
      forAllBlind (genScene reader [1e-7, 0.0005, 0.01, 0.09, 0.2, 0.8]) $ \scene ->
        forAllBlind (genScene reader [1e-7, 0.05, 0.2]) $ \others ->
          forAll (elements [Guaranteed, UpTo 0, UpTo 1, UpTo 2]) $ \radius ->
            forAll (elements [0.01, 0.3, 0.9]) $ \tolerated ->
              forAll ((,) <$> elements [0, 0.005, 0.3] <*> elements [0, 0, 1, 2, 3]) $
                \(share, apart) ->
                  let numbered from symbols = zipWith (\n s -> s {readNumber = n}) [from ..] symbols
                      spare = take apart (concat (Map.elems (sceneCells others)))
                      (strays, dissenters) =
                        splitAt (length spare `div` 2) (numbered 100 spare)
                      whole = concat (Map.elems (sceneCells scene))
                      (left, right') = partition ((< 0.5) . half . readNumber) whole
                      half n = fromIntegral (n `mod` 3) / 3 :: Double
                      groups' = map (Set.fromList . map readNumber) [left, right']
                      seenCells
                        | quarterTurns (sceneOrientation scene) >= 2 = halfAbout (sceneCells scene)
                        | otherwise = sceneCells scene
                      grid = FaceGrid seenCells groups' strays
                      tolerance = Tolerance tolerated radius share
                      asked limit =
                        locateGrid reader tolerance {toleratedDoubt = limit} dissenters grid
                      found = asked tolerated
                      -- At the doubt itself it is tolerated.
                      limits =
                        tolerated :
                        filter (< 0.4) [evidenceDoubt e | Just e <- [locationEvidence found]]
                   in conjoin
                        [ defined
                            reader
                            tolerance {toleratedDoubt = limit}
                            dissenters
                            grid
                            (asked limit)
                          | limit <- limits
                        ]
  where
    halfAbout cells =
      let (high, wide) = (maximum (0 : map fst keys), maximum (0 : map snd keys))
          keys = Map.keys cells
       in Map.mapKeys (\(i, j) -> (high - i, wide - j)) cells

-- | Whether a grid's location is what the definitions say.
defined ::
  KnownField k => Recogniser k -> Tolerance -> [ReadSymbol] -> FaceGrid -> GridLocation -> Property
defined reader tolerance dissenters grid came
  | null positions || null observed =
    (show (locationEvidence came), label' came) === ("Nothing", label' came)
  | tied = label "tied" True
  | otherwise =
    label (takeWhile (/= ' ') (show outcome)) $
      conjoin
        [ locationOrientation came === orientation,
          Map.map (map readNumber) (locationCells came) === Map.map (map readNumber) cells,
          counterexample "outcome" $ show (locationOutcome came) === show outcome,
          case locationEvidence came of
            Nothing -> counterexample "no evidence" False
            Just e ->
              conjoin
                [ evidenceAgreeing e === length agreeing,
                  sort (evidenceWrong e) === sort (map readNumber wrong),
                  evidenceInconsistent e
                    === [ source
                          | source <- [0 .. 2],
                            ((>) `on` length . filter ((== source) . readSource)) wrong agreeing
                        ],
                  evidenceDistance e === distance,
                  evidenceRadius e === radius,
                  near (doubtOfPosition (evidenceDoubts e)) (other * (1 - alien)),
                  doubtOfStitching (evidenceDoubts e) === 0,
                  near (doubtOfOrigin (evidenceDoubts e)) alien,
                  fmap chanceExact (evidenceChance e) === Just False,
                  near (maybe (-1) chanceShare (evidenceChance e)) located
                ]
        ]
  where
    codebook = recogniserCodebook reader
    label' = show . locationEvidence
    (orientation, orientationDoubt) = likeliestOrientation 4 (gridCells grid)
    cells = seenOnFace orientation (gridCells grid)
    -- What each observed cell says of the classes, which come to 1.
    observed =
      [ (cell, map (/ sum weights) weights)
        | (cell, here) <- Map.toList cells,
          let weights =
                [ product (map (sum . saying (orientation, c)) here)
                  | c <- [0 .. 3]
                ],
          sum weights > 0
      ]
    saying wanted s = [p | (what, p) <- readChances s, what == wanted]
    positions =
      [ (at, likelihood)
        | r <- [0 .. 14],
          c <- [0 .. 16],
          let at = Position r c,
          Just codes <- [traverse (fmap snd . cellOf reader at . fst) observed],
          let likelihood = product (zipWith (\code (_, ps) -> ps !! code) codes observed)
      ]
    total = sum (map snd positions)
    (place, most) = maximumBy (comparing snd) positions
    tied = total <= 0 || length (filter ((> 0.999 * most) . snd) positions) > 1
    elsewhere' = (total - most) / total
    other = 1 - (1 - orientationDoubt) * (1 - elsewhere')
    -- Bayes' theorem for what is foreign, of which every content is as likely; of what is the
    -- array's one symbol in a hundred is not what it seems.
    share = foreignPrior tolerance
    theirs = share / 4 ^ length observed
    ours =
      (1 - share) / 255 / (1 - elsewhere')
        * product
          [ 0.99 * sum (map (ps !!) (maybe [] (pure . snd) (cellOf reader place cell))) + 0.01 / 4
            | (cell, ps) <- observed
          ]
    alien = if share <= 0 then 0 else theirs / (theirs + ours)
    -- The certain symbols.
    ways =
      [ (cell, s, o, c)
        | (cell, here) <- Map.toList cells,
          s <- here,
          Just (o, c) <- [certain s]
      ]
    known = [w | w@(_, _, o, _) <- ways, o == orientation]
    (fitting', misfits) =
      partition (\(cell, _, _, c) -> fmap snd (cellOf reader place cell) == Just c) known
    agreeing = [s | (_, s, _, _) <- fitting']
    otherWayUp =
      [s | (_, s, o, _) <- ways, o /= orientation] ++ filter (isJust . certain) dissenters
    astray = filter (isJust . certain) (gridStrays grid)
    wrong = [s | (_, s, _, _) <- misfits] ++ otherWayUp ++ astray
    offsets = nub [Position (fromIntegral i) (fromIntegral j) | ((i, j), _, _, _) <- known]
    distance = observedDistance codebook offsets
    radius = case toleratedErrors tolerance of
      Guaranteed -> if distance == 0 then 0 else (distance - 1) `div` 2
      UpTo n -> n
    -- How many contents of the certain cells lie in the spheres about all positions' contents.
    located =
      let m = length offsets
          inSphere = sum [binomial m i * 3 ^ i | i <- [0 .. min m (fromIntegral radius)]]
       in min 1 (fromIntegral (length admissible' * inSphere) / 4 ^ m) :: Double
    binomial n k = product [n - k + 1 .. n] `div` product [1 .. k] :: Int
    admissible' = positions
    -- What the symbols that the network knows say alone.
    exactly some =
      either (const (Refused TooFewCells)) id $ do
        known' <-
          shown . Locate.patch $
            map (map (>>= agreed)) (gridRows some)
        answer <-
          shown $
            locate
              (recogniserLocator reader)
              (onePatch (codebookSurface codebook) (Locate.Symbol <$> known'))
                { Locate.queryRadius = toleratedErrors tolerance
                }
        pure (Locate.candidatePosition <$> Locate.answerOutcome answer)
    shown :: Either e a -> Either () a
    shown = either (const (Left ())) Right
    agreed here = case nub [c | s <- here, Just (o, c) <- [readClass s], o == orientation] of
      [c] -> either (const Nothing) Just (elementOfClass c)
      _ -> Nothing
    together = exactly cells
    places =
      [ at
        | numbers <- gridGroups grid,
          let own = Map.map (filter ((`Set.member` numbers) . readNumber)) cells,
          Unique at _ <- [exactly own]
      ]
    apart = length (nub places) > 1
    count = fromIntegral . length
    outcome
      | orDoubt <= toleratedDoubt tolerance + 1e-12,
        maybe True ((<= toleratedDoubt tolerance) . evidenceDoubt) (locationEvidence came) =
        if count wrong <= radius then Placed place else contradicted
      | count otherWayUp > radius = WrongWayUp
      | otherwise = case together of
        Unique _ _ -> Unplaced BelowThreshold
        Ambiguous those (_ : _) -> Undecided those
        Refused reason
          | reason `elem` [TooFewCells, NoCompleteWindow] -> Unplaced NoCompleteWindow
          | apart -> GroupsApart
          | otherwise -> Unplaced reason
        _ -> Unplaced NoCompleteWindow
    orDoubt = other * (1 - alien) + alien
    contradicted
      | not (null otherWayUp), count wrong <= radius + count otherWayUp = WrongWayUp
      | not (null astray), count wrong <= radius + count astray = OffTheGrid
      | apart = GroupsApart
      | Refused reason <- together = Unplaced reason
      | otherwise = Unplaced Contradiction

near :: Double -> Double -> Property
near a b = counterexample (show (a, b)) (abs (a - b) <= 1e-9 + 1e-6 * abs b)

foundSpec :: KnownField k => [Recogniser k] -> Spec
foundSpec readers =
  it "what is found are the windows whose symbols are the array's, or where most of them are" $
    forAllBlind (elements readers) $ \reader ->
      forAllBlind (genScene reader [0]) $ \scene ->
        let found =
              findingAt
                reader
                (GridLocation (sceneOrientation scene) (sceneCells scene) Nothing GroupsApart)
                (scenePosition scene)
         in foundAsDefined reader scene found

-- | Whether what is found at a scene's position is what the definition says.
foundAsDefined :: KnownField k => Recogniser k -> Scene -> Maybe Finding -> Property
foundAsDefined reader (Scene orientation position cells) came =
  label (if null complete then "incomplete" else "complete") $ case (came, wanted) of
    (Just found, Just window) ->
      conjoin
        [ foundOrientation found === orientation,
          foundPlaces found
            === Map.fromList
              [ (readNumber s, SymbolPlace p c)
                | (cell, here) <- Map.toList cells,
                  Just (p, c) <- [at cell],
                  s <- here
              ],
          sameWindow (foundWindow found) window,
          length (foundWindows found) === length complete,
          conjoin (zipWith sameWindow (foundWindows found) complete)
        ]
    (Nothing, Nothing) -> property True
    (found, _) -> counterexample (show (isJust found, fmap third wanted)) False
  where
    at = cellOf reader position
    layout = recogniserPlacement reader
    third (_, _, w) = w
    end part = maximum (0 : map part (Map.keys cells))
    -- Cells with a symbol that is the array's there.
    agreeing said =
      [ cell
        | (cell, here) <- Map.toList cells,
          Just (_, c) <- [at cell],
          any ((== Just (orientation, c)) . said) here
      ]
    right' = agreeing readClass
    known = if null right' then agreeing (Just . readLikeliest) else right'
    windowsFrom first =
      [ (cell, block, ReadWindow p classes (seenAt cell block) (whereabouts layout (Shape 2 2) p))
        | i <- [first .. end fst],
          j <- [first .. end snd],
          let cell = (i, j),
          Just (p, _) <- [at cell],
          let block = [(i, j), (i, j + 1), (i + 1, j), (i + 1, j + 1)],
          let class' b = if b `elem` right' then snd <$> at b else Nothing,
          let classes = [map class' (take 2 block), map class' (drop 2 block)]
      ]
    complete = filter (\(_, block, _) -> all (`elem` right') block) (windowsFrom 0)
    -- Where its symbols have the centre, which is half a pitch from each.
    seenAt (i, j) block =
      mean
        [ (x - dx, y - dy)
          | b@(i', j') <- block,
            s <- Map.findWithDefault [] b cells,
            let (x, y) = readAt s,
            let (dx, dy) =
                  onOffset
                    orientation
                    (16 * (fromIntegral (j' - j) - 0.5), 20 * (fromIntegral (i' - i) - 0.5))
        ]
    mean places =
      let n = fromIntegral (max 1 (length places))
       in (sum (map fst places) / n, sum (map snd places) / n)
    felt (_, block, w) = (length (filter (`elem` known) block), isJust (faceOf w))
    faceOf w = case windowWhereabouts w of
      OnFace place -> Just (placeFace place)
      _ -> Nothing
    faces =
      nub
        [ placeFace place
          | Just (p, _) <- map at known,
            OnFace place <- [whereabouts layout (Shape 1 1) p]
        ]
    onTheFace =
      [ w
        | [face] <- [faces],
          w@(_, _, window) <- windowsFrom (-1),
          fst (felt w) > 0,
          faceOf window == Just face
      ]
    wanted = listToMaybe (mapMaybe best [take 1 complete, onTheFace, windowsFrom 0])
    -- The first of those with the most.
    best ws = listToMaybe [w | w <- ws, felt w == maximum (map felt ws)]
    sameWindow a (_, _, b) =
      (windowPosition a, windowClasses a, windowWhereabouts a)
        === (windowPosition b, windowClasses b, windowWhereabouts b)
        .&&. near (fst (windowSeenAt a)) (fst (windowSeenAt b))
        .&&. near (snd (windowSeenAt a)) (snd (windowSeenAt b))
