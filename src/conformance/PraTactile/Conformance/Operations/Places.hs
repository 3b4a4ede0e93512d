{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The operations that find places: by the table of all windows, by the fewest differences, by
-- probabilities.
module PraTactile.Conformance.Operations.Places
  ( locate,
    nearest,
    posterior,
  )
where

import Control.Monad (replicateM)
import Data.Aeson (Value (..), toJSON, (.=))
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Bifunctor (first)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (Shape), area)
import PraTactile.Conformance.Answer
import PraTactile.Conformance.Definition.Array (ProfileFacts (..))
import qualified PraTactile.Conformance.Definition.Locate as Definition
import qualified PraTactile.Conformance.Definition.Windows as Windows
import PraTactile.Conformance.Forms
import PraTactile.Conformance.Laws.Draw (places, seenAt)
import PraTactile.Conformance.Library.Prepared
import PraTactile.Conformance.Operation
import PraTactile.Conformance.Operations.Arrays (everyContent, notOfVast)
import PraTactile.Conformance.Operations.Conventions
import PraTactile.Conformance.Question hiding (Symbol)
import PraTactile.Conformance.Stage
import PraTactile.Conformance.Vectors.Draw
import PraTactile.Conformance.Vectors.Flag
import PraTactile.Conformance.Vectors.Patches
import PraTactile.Conformance.Wire.Line (longestLine)
import PraTactile.Field (GF, KnownField)
import PraTactile.Format.Error (Misfit (NotList, NotObject))
import PraTactile.Format.Json.Codec hiding (integer, natural, refuse, shape)
import qualified PraTactile.Format.Json.Codec as Codec
import PraTactile.Format.Json.Schema (Schema)
import qualified PraTactile.Format.Json.Schema as Schema
import PraTactile.Locate hiding (Chance, Patch, Posterior, locate, probabilities)
import qualified PraTactile.Locate as Locate
import PraTactile.Locate.Patch (completeWindows)
import PraTactile.Profile (Profile (..))

-- Patches.

-- | Rows of cells, with what is known of each.
rowsOf :: Codec a -> Codec [[a]]
rowsOf = ofAtLeast 1 . listOf . listOf

patchForm :: Codec Patch
patchForm = rowsOf (nullable natural)

-- | Which patches laws and vectors ask about: the window and a cell, as they are somewhere.
typicalPatches :: ProfileFacts -> [Patch]
typicalPatches k =
  [ map (map Just) (seenAt k shape place)
    | shape <- [profileWindow p, Shape 1 1],
      place <- take 1 (places p shape)
  ]
  where
    p = knownProfile k

-- | Patches that are refused: of nothing, of zeros, and a window with every cell another one.
refusedPatches :: ProfileFacts -> [Patch]
refusedPatches k =
  [[Nothing]] :
    [ map (map change) rows
      | place <- take 1 (places p (profileWindow p)),
        rows <- [seenAt k (profileWindow p) place],
        change <- [const (Just 0), Just . (`mod` profileOrder p) . (+ 1)]
    ]
  where
    p = knownProfile k

-- | The window where patches of vectors begin.
windowPatch :: ProfileFacts -> Patch
windowPatch k = patchAt k 1 1 (profileWindow (knownProfile k))

-- | The window at corners of the array, larger patches across the edges, patches of zeros, nothing
-- observed, cells that contradict each other, and what is no patch.
patchEdges :: ProfileFacts -> [Patch]
patchEdges k =
  [patchAt k r c shape | r <- [0, n1 - 1], c <- [0, n2 - 1], shape <- [window, larger]]
    ++ [ map (map (const (Just 0))) (patchAt k 0 0 window),
         map (map (const (Just 0))) (patchAt k 0 0 larger),
         map (map (const Nothing)) (patchAt k 0 0 window),
         changed (patchAt k 0 0 larger),
         changed (patchAt k 1 0 window),
         -- The upper left is beyond the edge, or not observed.
         unseen (patchAt k (n1 - 1) (n2 - 1) larger),
         unseen (patchAt k 1 1 larger),
         [],
         [[]],
         [[Just 0, Nothing], [Just 0]],
         [[Just q]]
       ]
    -- Of larger arrays such lists of places are long.
    ++ [[[Just a]] | area (profileShape profile) <= 1024, a <- [0, q - 1]]
  where
    profile = knownProfile k
    q = profileOrder profile
    Shape n1 n2 = profileShape profile
    window = profileWindow profile
    larger = Shape (rows' + 1) (columns' + 1)
    Shape rows' columns' = window
    -- The last cell is another one.
    changed = map reverse . reverse . onFirst (fmap (\a -> (a + 1) `mod` q)) . reverse . map reverse
    unseen = onFirst (const Nothing)
    onFirst f patch' = case patch' of
      (one : line) : others -> (f one : line) : others
      _ -> patch'

lessObserved :: Maybe Code -> [Maybe Code]
lessObserved one = case one of
  Nothing -> []
  Just code -> Nothing : map Just (lessNatural code)

-- Places.

-- | By the one key that says which of the three it is.
locationForm :: Codec Location
locationForm = Codec schema written $ \value -> case value of
  Object fields -> case filter (`KeyMap.member` fields) ["position", "positions", "count"] of
    ["position"] -> At <$> field "position" positionForm fields
    ["positions"] -> OneOf <$> field "positions" (listOf positionForm) fields
    ["count"] -> uncurry Coset <$> readKeys coset fields
    _ -> Codec.refuse NotObject
  _ -> Codec.refuse NotObject
  where
    written place = case place of
      At position' -> writeObject (key "position" positionForm id) position'
      OneOf several -> writeObject (key "positions" (listOf positionForm) id) several
      Coset count dimension -> writeObject coset (count, dimension)
    coset = (,) <$> key "count" natural fst <*> key "dimension" natural snd
    schema =
      Schema.Named "place" . Schema.AnyOf $
        [ schemaOf (alone "position" positionForm),
          schemaOf (alone "positions" (ofAtLeast 2 (listOf positionForm))),
          schemaOf (object coset)
        ]

-- | In place of a list of positions their number may stand, with the dimension of the coset that
-- they are: the degree less the rank of the observed cells, if that is known.
counted :: ProfileFacts -> Patch -> Location -> Location -> Location
counted k cells got wanted = case (wanted, got) of
  (OneOf several, Coset _ _) ->
    maybe wanted (Coset (fromIntegral (length several)) . less) rank
  _ -> wanted
  where
    degree = fromIntegral (length (profilePolynomial (knownProfile k))) - 1
    less r = degree - min degree r
    rank = Windows.maskOf (map (map drawn') cells) >>= Windows.prove k >>= proofRank
    drawn' = maybe '.' (const '#')

placesAnswer :: String
placesAnswer = "a place"

locate :: Operation Patch Location
locate =
  Operation
    { operationName = "locate",
      operationStage = OnLocate,
      operationSays = placesAnswer ++ ", by the complete windows",
      operationInput = alone "patch" patchForm,
      operationOutput = locationForm,
      operationReasons =
        [ tooFewCells,
          noCompleteWindow,
          ("zero-window", "no complete window occurs on the surface, and all of them are zeros"),
          notInArray,
          offSheet,
          contradiction,
          tableTooLarge
        ],
      operationLeast = const 1,
      operationWays =
        UnderProfile
          (meaning Definition.locate (of' why) ways windowPatch)
            { likened = counted,
              typical = typicalPatches,
              refused = refusedPatches,
              smaller = lessPatch lessObserved,
              asked = \k ->
                Group "Every content of a window." (Chosen (everyWindow k)) :
                ofCode Nothing (replicateM 96 (somePatch k)) (patchEdges k),
              flags = patchFlags . profileOrder
            }
          ( \it rows -> do
              observed <- observedIn it rows
              if preparedExact it /= TableDecoder
                && not (null (observedCells observed))
                && null (completeWindows (preparedWindow it) observed)
                then refuse (reasonName NoCompleteWindow)
                else locatedBy it (preparedExact it) Guaranteed observed
          )
    }
  where
    why p =
      "the memory table of all complete windows on the " ++ surfaceText p ++ "; " ++ foldingRule p
    ways = ("the memory table", "comparison with every position")
    -- The windows that there can be, if they are few.
    everyWindow k =
      let Shape _ wide = profileWindow (knownProfile k)
       in maybe [] (map (inRows (fromIntegral wide) . map Just)) (everyContent k)
    inRows :: Int -> [a] -> [[a]]
    inRows wide cells = case splitAt wide cells of
      (line, []) -> [line]
      (line, others) -> line : inRows wide others

nearest :: Operation (Maybe Natural, Patch) Location
nearest =
  Operation
    { operationName = "nearest",
      operationStage = OnDamage,
      operationSays = placesAnswer ++ " where at most `radius` cells differ",
      operationInput =
        object ((,) <$> key "radius" (nullable natural) fst <*> key "patch" patchForm snd),
      operationOutput = locationForm,
      operationReasons =
        [ tooFewCells,
          ("zero-window", "at most `radius` observed cells are not 0, or as for `locate`"),
          notInArray,
          offSheet,
          contradiction,
          ("beyond-radius", "every position differs in more than `radius` cells"),
          tableTooLarge,
          ("too-many-windows", "more windows than this decoder compares")
        ],
      operationLeast = const 1,
      operationWays =
        UnderProfile
          (meaning (uncurry . Definition.nearest) (of' why) ways ((,) Nothing . windowPatch))
            { likened = \k (_, cells) -> counted k cells,
              typical = \k ->
                [(radius, cells) | cells <- typicalPatches k, radius <- [Nothing, Just 1]],
              refused = map ((,) Nothing) . refusedPatches,
              smaller = \(radius, cells) ->
                [(radius, less) | less <- lessPatch lessObserved cells]
                  ++ [(Just e, cells) | Just e <- [radius] >>= traverse lessNatural],
              asked = \k ->
                notOfVast k $
                  ofCode
                    Nothing
                    ( replicateM 96 $
                        (,) <$> chosen Nothing [Nothing, Just 0, Just 1, Just 2] <*> somePatch k
                    )
                    [(radius, cells) | cells <- patchEdges k, radius <- [Nothing, Just 0, Just 1]],
              flags = \p (radius, cells) ->
                patchFlags (profileOrder p) cells ++ [StatedRadius | Just _ <- [radius]]
            }
          ( \it (radius, rows) ->
              observedIn it rows >>= locatedBy it NearestDecoder (maybe Guaranteed UpTo radius)
          )
    }
  where
    why p = "the observed cells are compared with those at every position of the " ++ surfaceText p
    ways = ("totals of differing cells", "comparison with every position")

tooFewCells,
  noCompleteWindow,
  notInArray,
  offSheet,
  contradiction,
  tableTooLarge ::
    (String, String)
tooFewCells = ("too-few-cells", "no cell was observed")
noCompleteWindow = ("no-complete-window", "no window of the patch has all its cells observed")
notInArray = ("not-in-array", "no complete window occurs on the surface")
offSheet =
  ( "off-sheet",
    "at a common place all cells on the sheet agree, but an observed or the upper left one is \
    \beyond it"
  )
contradiction = ("contradiction", "no position fits the observed cells")
tableTooLarge = ("table-too-large", "more positions than this decoder compares")

observedIn :: KnownField k => Prepared k -> Patch -> Wire (Locate.Patch (GF k))
observedIn it rows = traverse (traverse (traverse (element it))) rows >>= orRefuse "invalid" . patch

locatedBy ::
  KnownField k => Prepared k -> DecoderName -> Radius -> Locate.Patch (GF k) -> Wire Location
locatedBy it name radius observed = do
  let query = (onePatch (Symbol <$> observed)) {queryRadius = radius}
  found <- orRefuse "table-too-large" (Locate.locate (preparedLocator it name) query)
  case answerOutcome found of
    Unique candidate _ -> pure (At (candidatePosition candidate))
    Ambiguous candidates _ -> pure (OneOf (map candidatePosition candidates))
    AmbiguousMany count dimension -> maybe (refuse "invalid") (pure . Coset count) dimension
    Refused reason -> refuse (reasonName reason)

-- Probabilities.

chanceForm :: Codec Chance
chanceForm = Codec schema written $ \value -> case value of
  Null -> Right Unfelt
  Array _ -> Probably <$> readValue (listOf real) value
  _ -> Certainly <$> readValue natural value
  where
    written one = case one of
      Unfelt -> Null
      Certainly code -> writeValue natural code
      Probably numbers -> toJSON numbers
    schema =
      Schema.AnyOf
        [schemaOf natural, Schema.Null, Schema.list (share (1 :: Double))]

-- | A number from 0 to this one.
share :: Double -> Schema
share most = Schema.Real ["minimum" .= (0 :: Int), "maximum" .= most]

-- | A position and its probability.
likelyForm :: Codec (Position, Double)
likelyForm = Codec schema written $ \value -> do
  given <- readValue (listOf anything) value
  case given of
    [r, c, chance] ->
      (,) <$> (Position <$> readValue natural r <*> readValue natural c) <*> readValue real chance
    _ -> Codec.refuse NotList
  where
    written (Position r c, chance) = [writeValue natural r, writeValue natural c, toJSON chance]
    schema = Schema.Tuple [schemaOf natural, schemaOf natural, share 1.000000001]

posterior :: Operation Chances [(Position, Double)]
posterior =
  Operation
    { operationName = "posterior",
      operationStage = OnChances,
      operationSays =
        "`[[row, column, probability], ..]` in any order, correct to 10^-9; left out means 0",
      operationInput = alone "patch" (rowsOf chanceForm),
      operationOutput = listOf likelyForm,
      operationReasons = [contradiction, tooLong, tableTooLarge],
      operationLeast = const 1,
      operationWays =
        UnderProfile
          (meaning Definition.posterior (of' why) ways (certain . windowPatch))
            { likened = \k _ got wanted -> if sameChances k wanted got then got else wanted,
              typical = map certain . typicalPatches,
              refused = map certain . refusedPatches,
              smaller = lessPatch lessChance,
              asked = \k ->
                notOfVast k $
                  ofCode
                    Nothing
                    (replicateM 8 (somePatch k >>= someChances k))
                    (chanceEdges k),
              flags = chanceFlags . profileOrder,
              -- Exact up to one rounding; the library's depend on the machine's logarithms in their
              -- last digits.
              stated = const
            }
          ( \it chances ->
              traverse (traverse (probabilities (profileOrder (preparedProfile it)))) chances
                >>= posteriorBy (preparedLocator it PosteriorDecoder)
          )
    }
  where
    why p =
      "Bayes: the product of the probabilities of the symbols at each position of the "
        ++ surfaceText p
        ++ ", divided by their sum"
    ways = ("sums of logarithms", "products of exact fractions")

certain :: Patch -> Chances
certain = map (map (maybe Unfelt Certainly))

lessChance :: Chance -> [Chance]
lessChance known' = case known' of
  Unfelt -> []
  Certainly code -> Unfelt : map Certainly (lessNatural code)
  Probably chances ->
    Unfelt : [Certainly (fromIntegral i) | (i, x) <- zip [0 :: Int ..] chances, x > 0]

-- | Certainty, no knowledge, a contradiction, sums at some distance from 1, and what is no patch.
chanceEdges :: ProfileFacts -> [Chances]
chanceEdges k =
  [ certain (patchAt k 1 1 (profileWindow profile)),
    certain (patchAt k (n1 - 1) (n2 - 1) (profileWindow profile)),
    certain [[Just 0 | _ <- [0 .. n2]] | _ <- [0 .. n1]],
    [[Probably (0.5 : 0.4 : rest)]],
    [[Probably (0.5 : 0.4995 : rest)]],
    [[Probably (1.5 : -0.5 : rest)]],
    [[Probably (0 : 0 : rest)]],
    [[Probably (1 : rest)]],
    [[Certainly q]],
    [],
    [[]],
    [[Unfelt], [Unfelt, Unfelt]]
  ]
    ++ [[[Unfelt, Unfelt]] | area (profileShape profile) <= 300]
  where
    profile = knownProfile k
    q = profileOrder profile
    Shape n1 n2 = profileShape profile
    rest = replicate (fromIntegral q - 2) 0

-- | Whether two lists say the same to 10^-9: each position once, and each one of the array.
sameChances :: ProfileFacts -> [(Position, Double)] -> [(Position, Double)] -> Bool
sameChances k wanted got =
  Map.size given == length got
    && all inside (Map.keys given)
    && all ((<= 1e-9) . abs) (Map.unionWith (+) given (negate <$> Map.fromList wanted))
  where
    given = Map.fromList got
    inside (Position r c) = r < n1 && c < n2
    Shape n1 n2 = profileShape (knownProfile k)

-- | The probabilities of positions, without those that are 0. Refuses at once what no line has room
-- for.
posteriorBy :: KnownField k => Locator k -> [[Maybe [Double]]] -> Wire [(Position, Double)]
posteriorBy made chances = do
  beliefs <- orRefuse "invalid" (traverse (traverse (traverse belief)) chances)
  observed <- orRefuse "invalid" (patch beliefs)
  answer <-
    orRefuse "table-too-large" (Locate.locate made (onePatch (Probabilities <$> observed)))
  let possible = takeWhile ((> 0) . snd) (maybe [] posteriorRanking (answerPosterior answer))
  case drop (longestLine `div` shortest) possible of
    _ : _ -> refuse "too-long"
    [] | null possible -> refuse (reasonName Contradiction)
    [] -> pure (map (first candidatePosition) possible)
  where
    -- As [0,0,1], and a comma.
    shortest = 8
