{-# LANGUAGE OverloadedStrings #-}
-- | The parsers under hostile inputs, and what is done with what they accept.
module Test.Hostile.Parsers
  ( Kind (..)
  , kinds
  ) where

import Data.Aeson ((.=))
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes8
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.List (intercalate)
import qualified Data.Text as Text
import Data.Text.Encoding (decodeUtf8')
import qualified Data.Vector.Primitive as Primitive

import CsvGrid
import Json
import PraTactile.Format
import PraTactile.Format.Profile (profileText)
import Locating
import Locating.Seen
import Message
import PatchText
import PraTactile.Array
import PraTactile.Certificate
import PraTactile.Certificate.Check
import PraTactile.Classify.Network.File
import PraTactile.Field
import PraTactile.Grid (gridRows)
import PraTactile.Image.Pgm
import PraTactile.Locate.Nearest (Radius (..))
import PraTactile.Locate.Patch (patchRows)
import PraTactile.Locate.Soft
import PraTactile.Probe.Manifest
import PraTactile.Profile
import PraTactile.Shape (parseAlphabet, renderAlphabet)
import PraTactile.Window
import PraTactile.Window.Proof
import Test.Hostile.Census
import Test.Hostile.Judgement
import Test.Hostile.Specimens

-- | A kind of input: what it is called, what share of all inputs it gets, in thousandths, valid ones, and what becomes of one.
data Kind = Kind
  { kindName :: String
  , kindShare :: Int
  , kindSpecimens :: [ByteString]
  , kindJudged :: ByteString -> Judged
  }

kinds :: [Kind]
kinds =
  [ Kind "PGM files" 140 pgms judgedPgm
  , Kind "manifests" 110 manifests judgedManifest
  , Kind "patches" 160 patches judgedPatch
  , Kind "patches in unknown orientation" 40 patches judgedTurned
  , Kind "certificates" 110 certificates judgedCertificate
  , Kind "census files" 50 censuses judgedCensus
  , Kind "shards of a census" 30 (take 1 shards) judgedShard
  , Kind "profiles" 100 profiles judgedProfile
  , Kind "arrays as CSV" 70 grids judgedGrid
  , Kind "networks" 20 networks judgedNetwork
  , Kind "drawings of shapes" 20 drawings judgedDrawing ]

judgedPgm :: ByteString -> Judged
judgedPgm bytes = case decodePgm bytes of
  Left why -> Refused (imageMessage why)
  Right image -> Accepted
    [ ("decode . encode is the identity", decodePgm (encodePgm format image) == Right image) | format <- [Plain, Binary] ]
    (show image)

judgedManifest :: ByteString -> Judged
judgedManifest bytes = case parseManifest bytes of
  Left why -> Refused (manifestMessage why)
  Right entries -> Accepted [("parse . render is the identity", parseManifest (renderManifest entries) == Right entries)] (show entries)

-- | A text as the command line has it.
asText :: ByteString -> (String -> Judged) -> Judged
asText bytes use = either (const (Refused "it is not UTF-8 text")) (use . Text.unpack) (decodeUtf8' bytes)

judgedPatch, judgedTurned :: ByteString -> Judged
judgedPatch = patchJudge Upright
judgedTurned = patchJudge Any

-- | Patches on the paper's array, with everything that is said of them. What is prepared for the array is so once.
patchJudge :: Turning -> ByteString -> Judged
patchJudge turning = (`asText` answered)
  where
    answered = either (const (const (Refused "there is no array"))) id (withProfile canonicalProfile answering)
    answering :: KnownField k => PseudorandomArray k -> Mask -> String -> Judged
    answering array mask = case reporter (Choice Nothing Guaranteed 0.001 MostSignificantFirst) turning Torus array mask of
      Left why -> const (Refused why)
      Right locate -> \text -> case readPatches (Text.pack text) >>= \written -> (,) written <$> locate written of
        Left why -> Refused why
        Right (written, report) -> Accepted
          [("read . render is the identity", fmap shown (readPatches (Text.pack (rendered written)) `asTypeOf` Right written) == Right (shown written))]
          (said report)
    said report = unlines (show (answerOutcome answer) : show (answerCorrected answer) : details answer : answerExplained answer ++ reportTogether report)
      where answer = reportAnswer report
    details answer = Lazy8.unpack (encodeLine (mconcat [ key .= value | (key, value) <- answerDetails answer ]))

-- | Patches in the form in which they can be read again.
rendered :: KnownField k => Written k -> String
rendered written = case written of
  Alone (Symbols p) -> ofSymbols p
  Alone (Chances p) -> ofChances p
  DisplacedSymbols given -> intercalate " ; " [ show r ++ "," ++ show c ++ ": " ++ ofSymbols p | ((r, c), p) <- given ]
  DisplacedChances given -> "{\"patches\":" ++ listed [ "{\"at\":" ++ show [r, c] ++ ",\"cells\":" ++ ofChances p ++ "}" | ((r, c), p) <- given ] ++ "}"
  where
    ofSymbols p = intercalate " / " [ unwords (map (maybe "?" showElement) line) | line <- patchRows p ]
    ofChances p = listed [ listed (map (maybe "null" (show . Primitive.toList . probabilities)) line) | line <- softRows p ]
    listed items = "[" ++ intercalate "," items ++ "]"

-- | The same for comparison: probabilities, which are made to add up to 1 again, to nine decimals.
shown :: Written k -> ([(Integer, Integer)], [[[Maybe [Integer]]]])
shown written = case written of
  Alone (Symbols p) -> ([], [ofSymbols p])
  Alone (Chances p) -> ([], [ofChances p])
  DisplacedSymbols given -> (map fst given, map (ofSymbols . snd) given)
  DisplacedChances given -> (map fst given, map (ofChances . snd) given)
  where
    ofSymbols = map (map (fmap (pure . toInteger . toCode))) . patchRows
    ofChances = map (map (fmap (map (round . (* (1e9 :: Double))) . Primitive.toList . probabilities))) . softRows

-- | A certificate that is found good, whatever its seal says, must be right: the windows are visited.
judgedCertificate :: ByteString -> Judged
judgedCertificate bytes = case decodeCertificate bytes of
  Left why -> Refused (formatMessage "it" "a certificate" why)
  Right (CertificateFile certificate isSealed) -> case checkCertificate certificate of
    Left fault -> Refused ((if isSealed then "sealed: " else "") ++ faultMessage fault)
    Right () -> Accepted
      [ ("all windows are distinct", windowsAreDistinct certificate)
      , ("decode . encode is the identity", fmap fileCertificate (decodeCertificate (encodeCertificate certificate)) == Right certificate) ]
      (show certificate)
  where
    windowsAreDistinct certificate = either (const False) id $ do
      mask <- either (const (Left ())) Right (maskFrom (certificateMask certificate))
      let visited on array _ = proved . fst <$> prove on array mask
      either (const (Left ())) (either (const (Left ())) Right)
        (withProfile (certificateProfile certificate) (visited (profileSurface (certificateProfile certificate))))

judgedProfile :: ByteString -> Judged
judgedProfile bytes = case decodeProfile bytes of
  Left why -> Refused (formatMessage "it" "a profile" why)
  Right profile -> case withProfile profile (\array _ -> map (cellAt array) [Position 0 0, Position 1 1] `seq` ()) of
    Left why -> Refused (profileMessage why)
    Right () -> Accepted
      [("decode . encode is the identity", decodeProfile (encodeProfile profile) == Right profile)]
      (profileText profile)

-- | An array, and the verdict on its windows of 2 x 2.
judgedGrid :: ByteString -> Judged
judgedGrid bytes = case parseGrid Nothing bytes of
  Left why -> Refused why
  Right grid -> Accepted
    [("parse . render is the identity", parseGrid Nothing (Bytes8.pack (unlines (map csv (gridRows grid)))) == Right grid)]
    (either windowMessage (\mask -> either proofMessage show (proveGrid Torus grid mask)) (rectangle (Shape 2 2)))
  where csv = intercalate "," . map show

judgedNetwork :: ByteString -> Judged
judgedNetwork bytes = asText bytes $ \text -> case parseNetwork (Text.pack text) of
  Left why -> Refused (networkMessage why)
  Right found -> Accepted
    [("parse . render is the identity", parseNetwork (renderNetwork found) == Right found)]
    (Text.unpack (renderNetwork found))

judgedDrawing :: ByteString -> Judged
judgedDrawing bytes = asText bytes $ \text -> case parseAlphabet (Text.pack text) of
  Left why -> Refused (shapeMessage why)
  Right found -> Accepted
    [("parse . render is the identity", parseAlphabet (renderAlphabet found) == Right found)]
    (Text.unpack (renderAlphabet found))
