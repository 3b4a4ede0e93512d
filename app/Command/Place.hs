-- | @pra-tactile place@: lay the faces of any objects on an array, or prove that this is
-- impossible.
module Command.Place
  ( command,
  )
where

import ArrayChoice
import Control.Monad (unless, when)
import Counted
import qualified Data.ByteString.Char8 as Bytes
import Data.Char (isSpace)
import Data.Foldable (for_)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust, isNothing, listToMaybe)
import qualified Data.Text as Text
import Data.Traversable (for)
import ExitStatus
import Files (readBytes)
import FormatFile (readPlacement, writePlacement)
import Json (shapeText)
import Lines (largestLine)
import Message
import Message.Advice (adviceErrorMessage)
import NamedSolid
import Numeric.Natural (Natural)
import Options hiding (option)
import Output
import Polyhedra
import PraTactile.Advise
import PraTactile.Array (Position (..), PseudorandomArray, area)
import PraTactile.Field (KnownField)
import PraTactile.Format.Place
import PraTactile.Object.Canonical (canonicalPitch)
import PraTactile.Object.Placement hiding (more)
import PraTactile.Object.Placement.Search
import PraTactile.Object.Placement.Windows
import PraTactile.Object.WingedEdge
import PraTactile.PlainText (plainUtf8)
import PraTactile.Profile
import PraTactile.Rows (textLines)
import PraTactile.Window (maskFrom)
import PraTactile.Window.Distance
import PraTactile.Window.Proof (windowRank)
import Progress
import Visible

data Options = Options
  { subjects :: [String],
    listed :: Maybe FilePath,
    onto :: Maybe FilePath,
    smallest :: Bool,
    faces :: [(ObjectName, FaceName)],
    symbols :: Maybe Rational,
    begun :: Begun,
    seed :: Int,
    reading :: SolidReading,
    output :: Maybe FilePath,
    form :: AnswerForm
  }

command :: Subcommand
command =
  subcommand
    "place"
    "Lay the faces of objects on the array"
    "Lay the faces of objects on the array so that no two share a cell, by a search; or report \
    \that it cannot be done, and why. Faces that lie there already stay where they are. The status \
    \is 1 unless all faces are laid."
    [readingGroup, arrayGroup]
    [ "pra-tactile place cube parallelepiped --output placement.json",
      "pra-tactile place box:60x60x60 --symbols 1/2 --json",
      "pra-tactile place cube --smallest",
      "pra-tactile place lid=box:120x80x20 --face 'lid:V1 V2 V3 V4' --as-named"
    ]
    ( run
        <$> ( Options
                <$> many
                  ( argument
                      pathReader
                      ( metavar "OBJECT..." <> action "file"
                          <> help
                            "Files or names of polyhedra, as 'solid' takes them; NAME= in front \
                            \names the object"
                      )
                  )
                <*> optionalFile
                  "objects"
                  "FILE"
                  "A file that lists more objects, one a line; - is the standard input"
                <*> optionalFile
                  "onto"
                  "PLACEMENT"
                  "Add the objects to this file that 'place' wrote; its faces stay where they are"
                <*> switch
                  ( long "smallest"
                      <> help
                        "Choose the smallest array over GF(q) that has room for all faces, each \
                        \begun where it has the most symbols; and of its windows the one that lies \
                        \wholly on the most faces. --q is 4 unless given"
                  )
                <*> many
                  ( valued
                      faceReader
                      "face"
                      "OBJECT:VERTICES"
                      "Lay this face, and of its object only faces named by --face; may be \
                      \repeated (default: all faces that have room for a symbol)"
                  )
                <*> optional symbolsOption
                <*> ( orAliasFlag
                        "upright"
                        AsNamed
                        ( flag'
                            AsNamed
                            ( long "as-named"
                                <> help
                                  "Begin each face at the first vertex of its name (default: where \
                                  \it has the most symbols, or elsewhere if there is no placement \
                                  \then)"
                            )
                        )
                        <|> pure AnyVertex
                    )
                <*> seedOption (value 1 <> showDefault)
                <*> readingOptions
                <*> optionalFile "output" "FILE" "Write the placement to this file"
                <*> jsonSwitch "Print the report as JSON"
            )
        <*> arrayChoice
    )

-- | @OBJECT:VERTICES@, the vertices separated by spaces or commas.
faceReader :: ReadM (ObjectName, FaceName)
faceReader = eitherReader $ \text -> case break (== ':') text of
  (owner@(_ : _), ':' : walk@(_ : _)) ->
    Right (objectCalled owner, readFaceName [if c == ',' then ' ' else c | c <- walk])
  _ -> Left (quoted text ++ " is not a face; write OBJECT:VERTICES, as in 'cube:C1 C2 C3 C4'")

run :: Options -> ArrayChoice -> IO ExitStatus
run options choice = do
  mapM_ orUnwritable (output options)
  (chosen, between, before) <- ground choice options
  names <- (subjects options ++) <$> maybe (pure []) objectLines (listed options)
  when
    (null names && null (faces options))
    ( misused
        "no object is named; 'pra-tactile solid --help' has the names of solids"
    )
  formatHeeded (readingFormat (reading options)) (map sourceOf names) Nothing
  new <- for names (namedSolid (profileShape <$> chosen) between (reading options))
  let known = maybe [] placementSolids before ++ new
      lying = maybe [] laidFaces before
      laidOn profile layings = placement (profileShape profile) between known layings
  -- Repeated names and unknown faces are refused before the search.
  _ <- orUnusable placementMessage (laidOn (fromMaybe canonicalProfile chosen) (map layingOf lying))
  wishes <- wanted between options known new
  let bare = [body | body <- new, solidName body `notElem` map (faceObject . wantedFace) wishes]
      search asked of' = layingsOf (seed options) (profileShape of') between lying known asked
      needed asked =
        fromInteger (sum (map laidCells lying) + cellsNeeded between known asked)
      laidOf asked = do
        arrays <- maybe (smallestArrays choice (needed asked)) (\it -> pure [[it]]) chosen
        pure (needed asked, firstLaid (map laidBlock lying) (search asked) arrays)
      -- Why no array has room for the wanted faces.
      hopeless
        | null wishes = Just (nothingCarries between new)
        | otherwise =
          listToMaybe
            [ noRoomOn between (wantedFace wish)
              | wish <- wishes,
                faceObject (wantedFace wish) `elem` map fst (faces options),
                cellsNeeded between known [wish] == 0
            ]
  (cells, (profile, found)) <- case chosen of
    _ | isJust hopeless -> pure (0, (fromMaybe canonicalProfile chosen, NoneFound))
    Nothing | any ((== AnyVertex) . wantedBegun) wishes -> do
      best <- laidOf [wish {wantedBegun = BestVertex} | wish <- wishes]
      case best of
        (_, (_, LaidSo _)) -> pure best
        _ -> laidOf wishes
    _ -> laidOf wishes
  let report outcome reason layings windows =
        PlaceReport
          { placeOutcome = outcome,
            placeReason = reason,
            placeCells = area (profileShape profile),
            placeNeeded = cells,
            placeProfile = profile,
            placeLayings = layings,
            placeWindows = windows,
            placePress = leastPress (profileWindow profile)
          }
      refused outcome reason sentence =
        NotAnswered <$ told options (report outcome reason [] Nothing) sentence
  laying <- whileWorking "looking for where faces lie" found
  case laying of
    _ | Just why <- hopeless -> refused IsImpossible (Just nothingCarriedName) why
    NoWay why -> refused IsImpossible (Just (reasonName why)) (whyNot wishes why)
    NoneFound -> refused IsNotFound Nothing (noneFound ++ "; try another --seed")
    LaidSo layings -> do
      let all' = map layingOf lying ++ layings
      place <- orUnusable placementMessage (laidOn profile all')
      proofs <-
        orUnusable
          profileMessage
          (withProfile profile (\array _ -> proved array (map layBlock all')))
      let degree = fromIntegral (length (profilePolynomial profile)) - 1
      mapM_ (\file -> writePlacement file profile place) (output options)
      let reported = zipWith (reportedIn place) all' proofs
      told
        options
        (report IsPlaced Nothing reported (windowCounts place (profileWindow profile)))
        ( counted (length (laidFaces place)) "face" "faces" ++ " on "
            ++ show (sum (map laidCells (laidFaces place)))
            ++ " of "
            ++ show (area (profileShape profile))
            ++ " cells"
            ++ concat
              [" of an array of " ++ shapeText (profileShape profile) | isNothing chosen]
        )
      for_ bare $ \body ->
        warn ("warning: the " ++ visible (objectText (solidName body)) ++ " carries no symbol")
      mapM_ warn (untold degree reported)
      pure Answered
  where
    laidCells = toInteger . length . blockCells . laidBlock
    reportedIn place laying proof =
      ReportedLaying
        { reportedLaying = laying,
          reportedProof = proof,
          reportedMost = do
            let Face owner name = layFace laying
            body <- placementObject place owner
            mostSymbols (placementPitch place) body name
        }

-- | The warning about faces whose cells have a rank below the polynomial's degree.
untold :: Natural -> [ReportedLaying] -> Maybe String
untold degree reported = case filter below reported of
  [] -> Nothing
  low@(first : _) ->
    Just
      ( "warning: " ++ counted (length low) "face cannot" "faces cannot"
          ++ " be told from other places of the array, for the rank of their cells is below "
          ++ show degree
          ++ ", the first of them "
          ++ faceOf (layFace (reportedLaying first))
      )
  where
    below one = any (< degree) (maskRank (reportedProof one))
    faceOf (Face owner walk) = visible (objectText owner) ++ ", " ++ visible (faceText walk)

-- | The first array on which all faces are laid, with the first of its windows that lies wholly on
-- the most faces; or the last array, if none has room. An array is given by its profiles, one for
-- each window.
firstLaid :: [Block] -> (Profile -> Found) -> [[Profile]] -> (Profile, Found)
firstLaid lying search arrays = case arrays of
  (profile : others) : more -> case search profile of
    LaidSo layings ->
      (foldl (better (lying ++ map layBlock layings)) profile others, LaidSo layings)
    found
      | all null more -> (profile, found)
      | otherwise -> firstLaid lying search more
  [] : more@(_ : _) -> firstLaid lying search more
  _ -> (canonicalProfile, NoneFound)
  where
    better blocks one other = if on blocks other > on blocks one then other else one
    on blocks profile = length (filter (holdsWindow (profileWindow profile)) blocks)

-- | The single arrays of at least this many cells, and at most 'mostCounted', in the adviser's
-- order.
smallestArrays :: ArrayChoice -> Natural -> IO [[Profile]]
smallestArrays choice cells = do
  q <- orderAlone choice
  options <- orUnusable adviceErrorMessage (singleArrays q (max 1 cells))
  pure
    [ [ maybe id foldedBy (foldingOf option) profile
        | fit <- optionFits option,
          Right profile <-
            [ chooseProfile
                (profileChoice q (fitPolynomial fit) (optionShape option))
                  { chosenWindow = Just (fitWindow fit)
                  }
            ]
      ]
      | option <- takeWhile ((<= mostCounted) . area . optionShape) options
    ]
  where
    foldingOf option = case optionLayout option of
      Single folding -> Just folding
      Joint _ -> Nothing

-- | The array, unless the smallest one is wanted; the distances of symbols; the faces that lie
-- there already.
ground :: ArrayChoice -> Options -> IO (Maybe Profile, Pitch, Maybe Placement)
ground choice options = case onto options of
  Just _
    | smallest options ->
      misused
        "--smallest looks for an array, but --onto names one; give one of them"
  Nothing | smallest options -> pure (Nothing, sized (fromMaybe 1 (symbols options)), Nothing)
  Nothing -> do
    profile <- chosenProfile choice
    orUnusable profileMessage (withProfile profile (\_ _ -> ()))
    pure (Just profile, sized (fromMaybe 1 (symbols options)), Nothing)
  Just file -> do
    (profile, before) <- readPlacement file
    unless (nothingChosen choice) $ do
      other <- chosenProfile choice
      unless (other == profile) . unusable $
        "the array's options describe another array than that of " ++ visibleName file
    unless (all ((== placementPitch before) . sized) (symbols options)) . unusable $
      "--symbols gives another size than the symbols have in " ++ visibleName file
    pure (Just profile, placementPitch before, Just before)
  where
    sized k = let Pitch right down = canonicalPitch in Pitch (k * right) (k * down)

-- | The objects that a file lists, one a line.
objectLines :: FilePath -> IO [String]
objectLines file = do
  bytes <- readBytes file
  when (any ((> largestLine) . Bytes.length) (Bytes.lines bytes)) . unusable $
    visibleName file ++ " has a line of more than " ++ show largestLine ++ " bytes"
  text <- orUnusable ((visibleName file ++) . notUtf8Message) (plainUtf8 bytes)
  pure [line | line <- textLines (Text.unpack text), not (all isSpace line)]

-- | The faces to be laid: those named by @--face@, and all faces of new objects without a named
-- one.
wanted :: Pitch -> Options -> [Solid] -> [Solid] -> IO [Wanted]
wanted between options known new = do
  said <- for (faces options) $ \(owner, walk) -> do
    body <-
      maybe (unusable (placementMessage (UnknownObject owner))) pure (Map.lookup owner byName)
    let face = Face owner walk
    when (walkNamed body walk == Nothing) . unusable . placementMessage $
      maybe (UnknownFace face) (WrongVertexOrder face) (sameCorners body walk)
    pure (Wanted face (begun options))
  let others = [body | body <- new, solidName body `notElem` map fst (faces options)]
  pure (said ++ facesOf between (begun options) others)
  where
    byName = Map.fromList [(solidName body, body) | body <- known]

-- | The proofs about the contents of blocks, computed once for equal blocks.
proved :: KnownField k => PseudorandomArray k -> [Block] -> [MaskProof]
proved array blocks = map (\given -> Map.findWithDefault unknown (cells given) proofs) blocks
  where
    cells = blockCells
    unknown = MaskProof Nothing Nothing
    proofs = Map.mapWithKey (\one () -> proof one) (Map.fromList [(cells b, ()) | b <- blocks])
    proof one = case maskFrom one of
      Left _ -> unknown
      Right mask ->
        MaskProof
          (Just (windowRank array mask))
          ( either
              (const Nothing)
              (\(Distance d failing) -> Just (d, failing))
              (minimumDistanceWithin (2 ^ (20 :: Int)) array mask)
          )

-- | Print the report, unless the placement goes to the standard output.
told :: Options -> PlaceReport -> String -> IO ()
told options report sentence =
  unless (placeOutcome report == IsPlaced && output options == Just "-") $
    printAs (form options) (unlines (reportText report sentence)) (encodePlace report)

reportText :: PlaceReport -> String -> [String]
reportText report sentence =
  (outcomeName (placeOutcome report) ++ ": " ++ sentence) :
  map layingText (take 40 layings)
    ++ ["  ... and " ++ show more ++ " more" | let more = length (drop 40 layings), more > 0]
    ++ [ "  windows of " ++ shapeText (profileWindow (placeProfile report)) ++ ": "
           ++ show (countOnFaces counts)
           ++ " on a face, "
           ++ show (countStraddling counts)
           ++ " on several, "
           ++ show (countOnNone counts)
           ++ " on none or on one in part"
         | Just counts <- [placeWindows report]
       ]
    ++ [ "  press " ++ show wide ++ "x" ++ show high
           ++ " taxels at least, so that a whole window lies in it"
         | placeOutcome report == IsPlaced,
           let (wide, high) = placePress report
       ]
  where
    layings = placeLayings report
    layingText one =
      let laying = reportedLaying one
          MaskProof rank apart = reportedProof one
          Face owner walk = layFace laying
          Position r c = layAt laying
       in "  " ++ visible (objectText owner) ++ ", " ++ visible (faceText walk) ++ ": "
            ++ symbolsText (layBlock laying)
            ++ " from row "
            ++ show r
            ++ ", column "
            ++ show c
            ++ concat ["; rank " ++ show n | Just n <- [rank]]
            ++ concat [", distance " ++ show d | Just (d, _) <- [apart]]
            ++ concat
              [ "; begun at " ++ visible (concatMap vertexText (take 1 (faceVertices name)))
                  ++ " it has "
                  ++ show most
                | Just (most, name) <- [reportedMost one],
                  most > reportedSymbols one
              ]
