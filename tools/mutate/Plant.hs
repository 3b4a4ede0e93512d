-- | Plants mutants: @plant HIE-FOLDER ROOT MUTANTS LEFT-OUT [OPTIONS]@ reads what the compiler
-- wrote about each module under @ROOT/src@ (@-fwrite-ide-info@), draws a sample of the mutants that
-- could be planted there ("Choice" has the options), rewrites the modules so that each site of the
-- sample asks "Mutant" what it is to do, and writes the sample, one JSON object a line. @LEFT-OUT@
-- is a file with the numbers of sites that are not to be planted, because there the function that
-- is planted does not type-check.
--
-- The number of a site is made of its name, so that a module in which nothing changed is planted
-- with the same text whatever changes in others.
module Main (main) where

import Choice
import Control.Monad (forM, forM_)
import qualified Crypto.Hash.SHA256 as SHA256
import Data.Aeson (encode)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Char (isDigit, isLetter)
import Data.IORef (atomicModifyIORef', newIORef)
import Data.List (intercalate, isPrefixOf, isSuffixOf, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import Data.Text (pack)
import Data.Text.Encoding (encodeUtf8)
import GHC.Data.FastString (unpackFS)
import GHC.Iface.Ext.Binary
import GHC.Iface.Ext.Types
import GHC.Types.Name (Name, isExternalName, nameModule, nameOccName, occNameString)
import GHC.Types.Name.Cache (initNameCache)
import GHC.Types.SrcLoc
import GHC.Types.Unique.Supply (mkSplitUniqSupply)
import GHC.Unit.Module (moduleName, moduleNameString)
import Kind
import Site (Mutant (..), mutantsOf)
import qualified Site
import System.Directory (doesDirectoryExist, listDirectory)
import System.Environment (getArgs)
import System.Exit (ExitCode (..), exitWith)
import System.FilePath ((</>))
import System.IO (hPutStrLn, stderr)
import Text.Printf (printf)

main :: IO ()
main = do
  arguments <- getArgs
  case arguments of
    hie : root : mutants : leftOut : options
      | Just choice <- chooseFrom options -> plant choice hie root mutants leftOut
    _ -> do
      hPutStrLn stderr ("usage: plant HIE-FOLDER ROOT MUTANTS LEFT-OUT " ++ usage)
      exitWith (ExitFailure 2)

plant :: Choice -> FilePath -> FilePath -> FilePath -> FilePath -> IO ()
plant choice hie root mutants leftOut = do
  without <- Set.fromList . map read . lines <$> readFile leftOut
  files <- filter (".hie" `isSuffixOf`) <$> filesUnder hie
  modules <- sortOn moduleFile <$> traverse readModule files
  let found = [(one, numbered one (sitesOf one)) | one <- modules]
      possible =
        [ describe one site
          | (one, sites) <- found,
            site@(number', _, _) <- sites,
            number' `Set.notMember` without
        ]
      drawn = sample choice possible
      wanted = Set.fromList (map (Site.siteNumber . mutantSite) drawn)
  forM_ found $ \(one, sites) ->
    writeFile
      (root </> moduleFile one)
      (planted [(n, site) | (n, site, _) <- sites, n `Set.member` wanted] (moduleText one))
  Lazy.writeFile mutants (Lazy.unlines (map encode drawn))
  printf
    "%d sites for %d mutants; %d are drawn, at %d sites\n"
    (length possible)
    (length (concatMap mutantsOf possible))
    (length drawn)
    (Set.size wanted)

-- | A module as the compiler saw it.
data Module = Module
  { moduleTitle :: String,
    moduleFile :: FilePath,
    moduleText :: String,
    moduleLines :: Map.Map Int String,
    moduleTrees :: [HieAST TypeIndex]
  }

readModule :: FilePath -> IO Module
readModule file = do
  supply <- mkSplitUniqSupply 'm'
  cache <- newIORef (initNameCache supply [])
  found <- hie_file_result <$> readHieFile (NCU (atomicModifyIORef' cache)) file
  text <- readFile' (hie_hs_file found)
  pure
    Module
      { moduleTitle = moduleNameString (moduleName (hie_module found)),
        moduleFile = hie_hs_file found,
        moduleText = text,
        moduleLines = Map.fromList (zip [1 ..] (lines text)),
        moduleTrees = Map.elems (getAsts (hie_asts found))
      }
  where
    readFile' name = readFile name >>= \text -> length text `seq` pure text

-- | A place where something may be planted.
data Site = Site
  { siteSpan :: RealSrcSpan,
    siteForm :: Form,
    siteKind :: Kind,
    -- | The definition at the top of the module that it is in.
    siteWithin :: String
  }

sitesOf :: Module -> [Site]
sitesOf one = concatMap top (moduleTrees one >>= nodeChildren)
  where
    top tree = visit (binding tree) (Nothing, tree)
    visit within (parent, tree)
      | inPattern tree = []
      | otherwise =
        here within parent tree
          ++ concatMap (\child -> visit within (Just tree, child)) (nodeChildren tree)
    here within parent tree =
      [ Site (nodeSpan which) form kind within
        | (which, form, kind) <- siteAt (textAt one) parent tree
      ]
    inPattern tree = any ((== "Pat") . snd) (annotations tree)

-- | What may be planted at a node.
siteAt ::
  (RealSrcSpan -> Maybe String) ->
  Maybe (HieAST TypeIndex) ->
  HieAST TypeIndex ->
  [(HieAST TypeIndex, Form, Kind)]
siteAt textOf parent tree =
  concat
    [ [ (tree, Instead, kind)
        | is "HsVar",
          Just kind <- [lookup (bare text) operators, lookup (bare text) functions],
          any (\name -> ofBase name && titleOf name == bare text) (names tree)
      ],
      [(tree, AppliedTo, number) | is "HsOverLit", not (null text), all isDigit text],
      [ (tree, AppliedTo, condition)
        | is "BodyStmt",
          Just guarded <- [parent],
          "GRHS" `elem` map fst (annotations guarded),
          text /= "otherwise"
      ],
      [(test, AppliedTo, condition) | is "HsIf", test : _ <- [nodeChildren tree]],
      [ (tree, AppliedTo, elements (length (nodeChildren tree)))
        | is "ExplicitList",
          "[" `isPrefixOf` text || null text,
          not (null (nodeChildren tree))
      ],
      [ (function, AppliedTo, exchanged)
        | is "HsApp",
          [applied, second] <- [nodeChildren tree],
          "HsApp" `elem` map fst (annotations applied),
          [function, first] <- [nodeChildren applied],
          [a] <- [variableType first],
          [b] <- [variableType second],
          a == b,
          textOf (nodeSpan first) /= textOf (nodeSpan second)
      ]
    ]
  where
    is name = name `elem` map fst (annotations tree)
    text = fromMaybe "" (textOf (nodeSpan tree))

-- | The type of a variable that is not instantiated there.
variableType :: HieAST TypeIndex -> [TypeIndex]
variableType tree =
  [ index
    | map fst (annotations tree) == ["HsVar"],
      [index] <- [concatMap nodeType (infos tree)]
  ]

ofBase :: Name -> Bool
ofBase name =
  isExternalName name
    && any
      (`isPrefixOf` moduleNameString (moduleName (nameModule name)))
      ["GHC.", "Data.", "Control."]

names :: HieAST TypeIndex -> [Name]
names tree = [name | info <- infos tree, Right name <- Map.keys (nodeIdentifiers info)]

infos :: HieAST TypeIndex -> [NodeInfo TypeIndex]
infos = Map.elems . getSourcedNodeInfo . sourcedNodeInfo

annotations :: HieAST TypeIndex -> [(String, String)]
annotations tree =
  [(unpackFS a, unpackFS b) | info <- infos tree, (a, b) <- Set.toList (nodeAnnotations info)]

-- | The name that a definition at the top gives.
binding :: HieAST TypeIndex -> String
binding tree =
  case filter ((/= "$") . take 1) (map titleOf (concatMap names (tree : nodeChildren tree))) of
    name : _ -> name
    [] -> "?"

titleOf :: Name -> String
titleOf = occNameString . nameOccName

-- | A name without the backticks that make an operator of it.
bare :: String -> String
bare = filter (/= '`')

-- | What stands at a span of one line.
textAt :: Module -> RealSrcSpan -> Maybe String
textAt one place
  | srcSpanStartLine place /= srcSpanEndLine place = Nothing
  | otherwise = slice <$> Map.lookup (srcSpanStartLine place) (moduleLines one)
  where
    slice = take (srcSpanEndCol place - srcSpanStartCol place) . drop (srcSpanStartCol place - 1)

-- | Each site with its number and the name that stays while other parts of the sources change: the
-- definition, the kind, which site of that kind it is there.
numbered :: Module -> [Site] -> [(Int, Site, String)]
numbered one = go Map.empty
  where
    go seen sites = case sites of
      [] -> []
      site : others ->
        let key = siteWithin site ++ " " ++ kindName (siteKind site)
            count = Map.findWithDefault (0 :: Int) key seen + 1
            name = key ++ " " ++ show count
         in (number' name, site, name) : go (Map.insert key count seen) others
    number' name = read ("0x" ++ take 12 (digest (moduleTitle one ++ " " ++ name)))

describe :: Module -> (Int, Site, String) -> Site.Site
describe one (number', site, name) =
  Site.Site
    { Site.siteNumber = number',
      Site.siteModule = moduleTitle one,
      Site.siteFile = moduleFile one,
      Site.siteLine = srcSpanStartLine (siteSpan site),
      Site.siteColumn = srcSpanStartCol (siteSpan site),
      Site.siteKind = kindName (siteKind site),
      Site.siteName = name,
      Site.siteVariants = map variantName (kindVariants (siteKind site)),
      Site.siteSource = digest (moduleText one)
    }

-- | The first 16 hexadecimal digits of the SHA-256 of a text.
digest :: String -> String
digest text =
  concatMap (printf "%02x") (Bytes.unpack (Bytes.take 8 (SHA256.hash (encodeUtf8 (pack text)))))

-- | A module's text with its sites planted.
planted :: [(Int, Site)] -> String -> String
planted sites source =
  unlines (imported (edited (lines source)))
  where
    edits = Map.fromListWith (++) (concatMap editsOf sites)
    edited rows = [maybe row (applyAll row) (Map.lookup i edits) | (i, row) <- zip [1 ..] rows]
    -- The planted functions stand first, before any splice that divides the module.
    imported rows = case break ("import " `isPrefixOf`) rows of
      (before, after@(_ : _)) ->
        let (listed, body) = splitAt (endOfImports after) after
         in before ++ imports ++ listed ++ definitions ++ body
      (_, []) -> case break ("where" `isSuffixOf`) rows of
        (before, header : after) -> before ++ header : imports ++ definitions ++ after
        _ -> rows
    endOfImports rows =
      let upToLast = length (dropWhile (not . isPrefixOf "import ") (reverse rows))
       in upToLast + length (takeWhile (\row -> null row || take 1 row == " ") (drop upToLast rows))
    definitions = concatMap definition sites ++ [""]
    imports = ["import qualified Mutant", "import qualified Original"]
    applyAll row = foldr change row . sortOn (\(column, order, _, _) -> (column, order))
    -- From the last column on, so that the columns before stay.
    change (column, _, width, text) row =
      let (before, after) =
            splitAt (column - 1) row
       in before ++ standing before after width text ++ drop width after
    -- An operator's place is taken by a name in backticks, but where it stands alone in
    -- parentheses.
    standing before after width text = case text of
      '\0' : name
        | '`' `elem` take width after -> "`" ++ name ++ "`"
        | any isLetter (take width after) -> name
        | "(" == take 1 (reverse before), ")" == take 1 (drop width after) -> name
        | otherwise -> "`" ++ name ++ "`"
      _ -> text

-- | The changes of lines that a site needs: the column, the order among those of one column, how
-- many characters go, and what comes.
editsOf :: (Int, Site) -> [(Int, [(Int, (Int, Int), Int, String)])]
editsOf (number', site) = case siteForm site of
  Instead ->
    [(srcSpanStartLine place, [(srcSpanStartCol place, (1, 0), width, "\0" ++ name)])]
  AppliedTo ->
    [ ( srcSpanStartLine place,
        [(srcSpanStartCol place, (0, negate extent), 0, "(" ++ name ++ " (")]
      ),
      (srcSpanEndLine place, [(srcSpanEndCol place, (-1, extent), 0, "))")])
    ]
  where
    place = siteSpan site
    name = "mutant" ++ show number'
    width = srcSpanEndCol place - srcSpanStartCol place
    -- Of spans that begin or end at one place the larger one is outside.
    extent = (srcSpanEndLine place - srcSpanStartLine place) * 1000 + width

-- | What a site calls: the variant that is on, or the original, of which it may be recorded that it
-- was evaluated and which variants would have been others.
definition :: (Int, Site) -> [String]
definition (number', site) =
  [""]
    ++ [fixity ++ " `" ++ name ++ "`" | Just fixity <- [kindFixity kind]]
    ++ [ name ++ " :: " ++ kindType kind,
         name ++ " " ++ kindArguments kind ++ " = case Mutant.chosen " ++ here ++ " of",
         "  {"
           ++ concat
             [ show i ++ " -> " ++ variantText variant ++ "; "
               | (i, variant) <- zip [1 :: Int ..] (kindVariants kind)
             ],
         "  0 -> " ++ kindOriginal kind ++ ";",
         "  _ -> Mutant.recorded " ++ here ++ " [" ++ differ ++ "] (" ++ kindOriginal kind ++ ")}",
         "{-# INLINE " ++ name ++ " #-}",
         here ++ " :: Mutant.Site",
         here ++ " = Mutant.site " ++ show number',
         "{-# NOINLINE " ++ here ++ " #-}"
       ]
  where
    kind = siteKind site
    name = "mutant" ++ show number'
    here = "site" ++ show number'
    differ = intercalate ", " (map variantDiffers (kindVariants kind))

filesUnder :: FilePath -> IO [FilePath]
filesUnder folder = do
  inside <- map (folder </>) <$> listDirectory folder
  fmap concat . forM inside $ \path -> do
    deeper <- doesDirectoryExist path
    if deeper then filesUnder path else pure [path]
