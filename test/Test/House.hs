-- | The rules of the house: two wings do not know each other, nothing pure reaches the world, and
-- of the code the objects see positions and shapes only. What else a module may use is hlint's
-- matter (.hlint.yaml, tools/pure.hlint.yaml).
module Test.House (spec) where

import Data.Char (isAlphaNum, isSpace, isUpper)
import Data.Foldable (for_)
import Data.List (isInfixOf, isPrefixOf, (\\))
import qualified Data.Map.Strict as Map
import House.Graph (dot, reaches)
import House.Source
import Test.Hspec

spec :: Spec
spec = describe "the house" $
  beforeAll read' $ do
    it "has modules in both wings, in the hall, and in what stands on them" $ \(house, _) ->
      [ Code,
        Touch,
        Simulation,
        Solid,
        Recognition,
        Files,
        Store,
        Conformance,
        App
      ]
        \\ map sourceWing house
        `shouldBe` []
    it "no wing imports one that it must not know, at once or through others" $ \(house, _) ->
      [ (sourceName one, path)
        | one <- house,
          (name, path) <- Map.toList (reaches house one),
          Just wing <- [Map.lookup name (wingsOf house)],
          wing `notElem` known (sourceWing one)
      ]
        `shouldBe` []
    it "a wing that knows another through others is found; rings are gone round once" $ \_ -> do
      let ring = [Source "A" Code ["B"] "", Source "B" Code ["A", "C"] "", Source "C" Touch [] ""]
      map (Map.keys . reaches ring) (take 1 ring) `shouldBe` [["A", "B", "C"]]
    it "what is pure may know only what is pure" $ \_ ->
      [(a, b) | a <- pureWings, b <- known a, b `notElem` pureWings] `shouldBe` []
    it "nothing pure imports what reaches the world, or speaks of IO" $ \(house, _) ->
      [ (sourceName one, word)
        | one <- house,
          sourceWing one `elem` pureWings,
          word <- filter impure (sourceImports one) ++ filter (== "IO") (wordsOf (sourceText one))
      ]
        `shouldBe` []
    it "the definition of fields and the factorisation of integers import base only" $
      \( house,
         _
         ) ->
          [ (sourceName one, name)
            | one <- house,
              sourceName one == "PraTactile.Field.Definition" || ofFactorisation (sourceName one),
              name <- sourceImports one,
              any (`isPrefixOf` name) beyondBase,
              not (ofFactorisation name)
          ]
            `shouldBe` []
    it "the linear codes know nothing of arrays: of the code they import fields" $ \(house, _) -> do
      let linear = filter (below "PraTactile.LinearCode" . sourceName) house
          others =
            [ (sourceName one, name)
              | one <- linear,
                name <- sourceImports one,
                below "PraTactile" name,
                not (any (`below` name) ["PraTactile.Field", "PraTactile.LinearCode"])
            ]
      length linear `shouldSatisfy` (> 1)
      others `shouldBe` []
    it "touch's folders follow the data: each imports itself and those above it" $ \(house, _) -> do
      let folder name = takeWhile (/= '.') (drop (length "PraTactile.") name)
          above one = takeWhile (/= folder (sourceName one)) touchFolders
          touch = filter ((== Touch) . sourceWing) house
          folders = map (folder . sourceName) touch
          backwards =
            [ (sourceName one, name)
              | one <- touch,
                name <- sourceImports one,
                Just Touch == Map.lookup name (wingsOf house),
                folder name `notElem` (folder (sourceName one) : above one)
            ]
      filter (`notElem` touchFolders) folders `shouldBe` []
      backwards `shouldBe` []
    it "the definition of conformance has of the code types alone" $ \(house, _) -> do
      let definition = filter (below "PraTactile.Conformance.Definition" . sourceName) house
          conformance =
            map ("PraTactile.Conformance." ++) (words "Definition Question Wire")
          foreign' line = case words line of
            "import" : name : listed
              | name == "qualified" -> foreign' (unwords ("import" : listed))
              | not (below "PraTactile" name) || any (`below` name) conformance -> False
              | otherwise -> null listed || not (all isType (typesOf (unwords listed)))
            _ -> False
          others =
            [ (sourceName one, line)
              | one <- definition,
                line <- lines (sourceText one),
                foreign' line
            ]
      length definition `shouldSatisfy` (> 1)
      others `shouldBe` []
    it "locating has one door: no other wing reaches for what is behind it" $ \(house, _) ->
      [ (sourceName one, name)
        | one <- house,
          sourceWing one /= Code,
          name <- sourceImports one,
          name `elem` ["PraTactile.Locate.Decoder.Codebook", "PraTactile.Locate.Foreign"]
      ]
        `shouldBe` []
    it "shipped shapes are fetched where they are chosen, and nowhere else" $ \(house, _) -> do
      let shipping = "PraTactile.Classification.Shipped"
          choosing =
            [ -- the library, with everything chosen, and its door
              "PraTactile.Decode",
              "PraTactile",
              -- the program, by its options; what it says where there are none
              "Setup",
              "Message.Touch",
              -- the protocol, which names the file
              "PraTactile.Conformance.Shapes"
            ]
          fetching = words "shippedAlphabet shippedNetwork shippedCalibration shippedReader"
          fetched one = filter (`elem` fetching) (wordsOf (sourceText one))
          embeds line =
            "embed" `isInfixOf` line
              && any (`isInfixOf` line) ["shapes.txt", "network.txt", "alphabets"]
          others = [one | one <- house, sourceName one `notElem` (shipping : choosing)]
      [sourceName one | one <- house, shipping `elem` sourceImports one] `shouldMatchList` choosing
      [(sourceName one, name) | one <- others, name <- fetched one] `shouldBe` []
      [sourceName one | one <- others, any embeds (lines (sourceText one))] `shouldBe` []
    it "of the code, the objects see positions and shapes only" $ \(house, _) ->
      [ (sourceName one, name)
        | one <- house,
          "PraTactile.Object" `isPrefixOf` sourceName one,
          name <- sourceImports one,
          Just Code == Map.lookup name (wingsOf house),
          name /= "PraTactile.Array"
      ]
        `shouldBe` []
    for_ [minBound ..] $ \wing ->
      it
        ( wingName
            wing
            ++ ": the package's description has all its modules, and only packages that it may use"
        )
        $ \(house, package) -> do
          let own = filter ((== wing) . sourceWing) house
              described = concat [text | (name, text) <- package, name == componentOf wing]
              names = filter (/= "program.Main") (map sourceName own)
          names \\ words described `shouldBe` []
          maybe [] (dependencies described \\) (Map.lookup wing allowances) `shouldBe` []
    it "what is public of the wings and the hall is 12 to 30 modules each, and ends nowhere" $
      \(house, package) -> do
        let shown face =
              [ name
                | (section, text) <- package,
                  section == face,
                  name <- drop 1 (dropWhile (/= "reexported-modules:") (words text)),
                  name /= ","
              ]
        [(face, length (shown face)) | face <- faces, length (shown face) `notElem` [12 .. 30]]
          `shouldBe` []
        concatMap shown faces \\ concat (replicate 3 (map sourceName house)) `shouldBe` []
    it "is drawn: each module in its wing, each import as an arrow" $ \_ -> do
      let module' name imports = Source ("PraTactile." ++ name) Code imports ""
          drawn = lines (dot [module' "A" ["PraTactile.B"], module' "B" ["Data.List"]])
      filter (elem '>') drawn `shouldBe` ["  \"PraTactile.A\" -> \"PraTactile.B\";"]
      filter ("  subgraph" `isPrefixOf`) drawn `shouldBe` ["  subgraph \"cluster_code\" {"]
  where
    read' = (,) <$> readHouse "." <*> (components <$> readText "pra-tactile.cabal")
    ofFactorisation = isPrefixOf "PraTactile.Factorisation"
    wingsOf house = Map.fromList [(sourceName one, sourceWing one) | one <- house]
    wordsOf text =
      words
        ( map
            (\letter -> if isAlphaNum letter || letter `elem` "_'" then letter else ' ')
            text
        )
    typesOf listed =
      words [if letter `elem` ".," then ' ' else letter | letter <- listed, letter `notElem` "()"]
    isType name = all isUpper (take 1 name)
    impure name = any (`below` name) world
    below folder name = name == folder || (folder ++ ".") `isPrefixOf` name

-- | The wings that a wing may import.
known :: Wing -> [Wing]
known wing = case wing of
  Common -> [Common]
  Code -> [Common, Code]
  Touch -> [Common, Touch]
  Simulation -> [Common, Code, Simulation]
  Solid -> [Solid]
  Recognition -> [Common, Code, Touch, Solid, Recognition]
  Formats -> Simulation : known Recognition ++ [Formats]
  Files -> known Formats ++ [Files]
  Store -> [Common, Code, Solid, Recognition, Store]
  Conformance -> known Formats ++ [Conformance]
  App -> [minBound ..]

-- | The wings without input and output.
pureWings :: [Wing]
pureWings = [Common, Code, Touch, Simulation, Solid, Recognition, Formats]

-- | What reads, writes, runs, changes or throws; tools/pure.hlint.yaml has the reasons.
world :: [String]
world =
  words
    "System.IO System.Directory System.Process System.Environment System.Exit System.Posix \
    \System.Timeout System.CPUTime System.Mem Data.Time Data.IORef Data.Unique Data.Text.IO \
    \Data.Text.Lazy.IO \
    \Data.ByteString.Internal Data.ByteString.Unsafe Foreign Control.Concurrent Control.Exception \
    \Control.Monad.IO Control.Monad.ST.Unsafe Control.Monad.ST.Lazy.Unsafe GHC.IO GHC.IORef \
    \GHC.ForeignPtr \
    \GHC.Ptr Debug.Trace Unsafe.Coerce"

-- | What the code may use beside base.
beyondBase :: [String]
beyondBase =
  words
    "PraTactile Crypto Data.ByteString Data.Vector Data.Map Data.IntMap Data.Set Data.IntSet \
    \Data.Sequence Data.Tree Data.Graph Data.Containers Data.Reflection"

componentOf :: Wing -> String
componentOf wing = case wing of
  _ | wing `elem` [Code, Touch, Recognition] -> "library " ++ wingName wing ++ "-internal"
  App -> "library command-line"
  _ -> "library " ++ wingName wing

-- | The packages that a wing may depend on beside base, but for those of the program.
allowances :: Map.Map Wing [String]
allowances =
  Map.map
    words
    ( Map.fromList
        [ (Common, "bytestring random text vector"),
          -- Bytes are what SHA-256 is taken of; nothing else in the code reads or writes them.
          (Code, "pra-tactile:common bytestring containers cryptohash-sha256 reflection vector"),
          ( Touch,
            "pra-tactile:common bytestring cassava containers file-embed hmatrix \
            \JuicyPixels random svg-builder text vector"
          ),
          (Simulation, "pra-tactile:common pra-tactile:code-internal containers random vector"),
          (Solid, "containers integer-logarithms random vector vector-algorithms"),
          ( Recognition,
            "pra-tactile:common pra-tactile:code-internal pra-tactile:touch-internal \
            \pra-tactile:solid bytestring containers filepath random vector"
          ),
          ( Formats,
            recognising
              ++ "pra-tactile:simulation aeson binary bytestring containers \
                 \integer-logarithms scientific text vector zip-archive"
          ),
          (Files, recognising ++ "pra-tactile:formats bytestring containers directory filepath"),
          ( Store,
            recognising
              ++ "bytestring containers directory filepath monad-logger persistent \
                 \persistent-sqlite text transformers unix"
          ),
          ( Conformance,
            recognising
              ++ "pra-tactile:formats aeson base64-bytestring bytestring containers directory \
                 \file-embed filepath process QuickCheck random scientific text transformers unix \
                 \vector"
          )
        ]
    )
  where
    recognising =
      "pra-tactile:common pra-tactile:code-internal pra-tactile:touch-internal \
      \pra-tactile:solid pra-tactile:recognition-internal "

-- | The libraries for others whose modules are those of private ones, of which they show some.
faces :: [String]
faces = ["library", "library code", "library touch"]

-- | The sections of the package's description: the first line of each, and the others.
components :: String -> [(String, String)]
components text = case dropWhile indented (lines text) of
  [] -> []
  heading : more ->
    let (body, others) = span indented more
     in (heading, unlines body) : components (unlines others)
  where
    indented line = all isSpace (take 1 line)

-- | The packages in a section, each the first word of a line after @build-depends:@ that is
-- indented deeper.
dependencies :: String -> [String]
dependencies section =
  [ name
    | line <-
        takeWhile
          ("    " `isPrefixOf`)
          (drop 1 (dropWhile (/= "  build-depends:") (lines section))),
      name : _ <- [words (filter (/= ',') line)]
  ]

-- | The folders of touch, and the modules of their names, in the order of the data.
touchFolders :: [String]
touchFolders =
  words "Geometry Steps Image Shape Sensor Composite Registration Segmentation Classification"
