-- | Objects with their symbols raised as files: surfaces, nets, and drawings of faces.
module EmbossedFiles
  ( SurfaceFormat (..),
    surfaceFormats,
    surfaceFile,
    netFiles,
    drawnFiles,
  )
where

import Control.Monad (when)
import Data.Bifunctor (first)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isControl, ord)
import Data.Containers.ListUtils (nubOrdOn)
import Data.List (intercalate)
import qualified Data.Map.Strict as Map
import qualified Data.Vector as V
import ExitStatus (ExitStatus (..))
import Message
import Message.Emboss
import Numeric (showHex)
import Picture.Net
import Picture.Raised
import Picture.Template
import PraTactile.Array (PseudorandomArray)
import PraTactile.Emboss
import PraTactile.Emboss.Face (Stamp (..))
import PraTactile.Emboss.Rounding
import PraTactile.Field (KnownField)
import PraTactile.Format.Emboss
import PraTactile.Format.Solid (SolidFormat (..), Written (..), writeSolid)
import PraTactile.Format.Solid.ThreeMf (writeThreeMf)
import PraTactile.Geometry (taxelPitch)
import PraTactile.Object.Description (rotations)
import PraTactile.Object.Mesh (Mesh, meshPoints, meshWalks)
import PraTactile.Object.Net
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Shape (Alphabet)
import Visible

-- | A format that surfaces are written in.
data SurfaceFormat = SurfaceFormat
  { -- | as @--format@ names it
    surfaceName :: String,
    -- | of the names of its files, from the dot on
    surfaceEnding :: String,
    -- | which coordinates it has
    surfacePrecision :: Precision,
    surfaceWriter :: Mesh -> Written Builder.Builder
  }

-- | The formats of surfaces. Of those with the same ending, a name stands for the first.
surfaceFormats :: [SurfaceFormat]
surfaceFormats =
  [ SurfaceFormat "stl" ".stl" Binary32 (writeSolid Stl),
    SurfaceFormat "ascii-stl" ".stl" Decimals (writeSolid StlText),
    SurfaceFormat "obj" ".obj" Decimals (writeSolid Obj),
    SurfaceFormat "3mf" ".3mf" Decimals writeThreeMf,
    SurfaceFormat "json" ".json" Fractions (writeSolid Json)
  ]

-- | An object or a plate as a file, which is called after the object.
surfaceFile ::
  KnownField k =>
  SurfaceFormat ->
  Alphabet ->
  PseudorandomArray k ->
  Placement ->
  EmbossSubject ->
  Either String (MadeFile, Lazy.ByteString)
surfaceFile format alphabet array layout subject = do
  made <- first embossMessage (embossed alphabet array layout subject)
  object <- first placementMessage (findObject layout named)
  found@(Rounded it most) <- first why (rounded precision made)
  first why (uncut object made found)
  Right
    ( MadeFile
        { madeFile = fileName (objectText named) ++ surfaceEnding format,
          madeObject = named,
          madeFace = embossedFace made,
          madeVertices = Just (V.length (meshPoints it)),
          madeTriangles = Just (V.length (meshWalks it)),
          madeVolume = Just (embossedVolume made),
          madeTaxels = embossedTaxels made,
          madeStroke = embossedStroke made,
          madeHeight = Just (embossedHeight made),
          madeMostRounded = most
        },
      Builder.toLazyByteString (writtenBytes (surfaceWriter format it))
    )
  where
    named = subjectName subject
    precision = surfacePrecision format
    why = misshapenMessage named precision

-- | An object unfolded, as a drawing, or as one for each page of this size. An object without a
-- net, or with a face that is larger than a page, is well formed, and refused.
netFiles ::
  KnownField k =>
  Maybe (Double, Double) ->
  Alphabet ->
  PseudorandomArray k ->
  Placement ->
  ObjectName ->
  Either (ExitStatus, String) [(MadeFile, Lazy.ByteString)]
netFiles page alphabet array layout named = do
  object <- first (unfit . placementMessage) (findObject layout named)
  (scale, symbolsOf') <- first (unfit . embossMessage) (symbolsOn alphabet array layout carrying)
  (lying, owners, tree) <- first (refused . noNetMessage named) (pickCut mostTried object)
  let raising =
        Raising
          { raisingSolid = lying,
            raisingParts =
              Map.fromList [it | it@(part, face) <- zip (solidFaces lying) owners, part /= face],
            raisingLaid = laidAs,
            raisingSymbols = symbolsOf',
            raisingTaxel = fromRational (scale * taxelPitch)
          }
      stamps = map snd . nubOrdOn fst . concatMap (cellsOn raising)
      raised = raisedOn raising
      net = layOut lying tree
      upright = net {netFaces = map begun (netFaces net)}
      everyFace = netFaces upright
      told ending faces =
        (drawing (fileName (objectText named) ++ ending) named Nothing scale (stamps everyFace))
          { madeTaxels = sum (map stampArea (stamps faces)),
            madeMostRounded = netRounding
          }
  when (null (stamps everyFace)) (Left (unfit (embossMessage (NothingRaised named))))
  case page of
    Nothing -> Right [(told ".net.svg" everyFace, cutOutSvg title raised upright)]
    Just size -> do
      pages <- first (refused . pageMessage named size) (pagesSvg size title raised upright)
      Right
        [ (told (".net-" ++ padded (length pages) number ++ ".svg") faces, bytes)
          | (number, (faces, bytes)) <- zip [1 ..] pages
        ]
  where
    unfit = (,) Unusable
    refused = (,) NotAnswered
    title = "The " ++ visible (objectText named) ++ ", unfolded"
    carrying = [laid | laid <- laidFaces layout, faceObject (laidFace laid) == named]
    laidAs = placementLaid layout . Face named
    padded count number =
      let digits = show (number :: Int)
       in replicate (length (show count) - length digits) '0' ++ digits
    -- A face begun where its laying begins.
    begun face = case laidAs (netFaceName face) of
      Nothing -> face
      Just laid ->
        let FaceName walk = faceName (laidFace laid)
            corners = zip (faceVertices (netFaceName face)) (netCorners face)
         in NetFace
              (FaceName walk)
              (concat (take 1 [map snd from | from <- rotations corners, map fst from == walk]))

-- | Faces as drawings, each called after its object and its vertices.
drawnFiles ::
  KnownField k =>
  Alphabet ->
  PseudorandomArray k ->
  Placement ->
  Either PlacementError [LaidFace] ->
  Either String [(MadeFile, Lazy.ByteString)]
drawnFiles alphabet array layout asked' = do
  faces <- first placementMessage asked'
  (scale, symbols) <- first embossMessage (symbolsOn alphabet array layout faces)
  Right (zipWith (drawn scale symbols) [1 ..] faces)
  where
    drawn scale symbols number laid =
      ( drawing (named (number :: Int) face) object (Just face) scale (map snd (symbols laid)),
        templateFile (Template laid (scale * taxelPitch) (symbols laid))
      )
      where
        Face object face = laidFace laid
        named k (FaceName vertices)
          | length full > 200 = fileName (objectText object) ++ ".face-" ++ show k ++ ".svg"
          | otherwise = full
          where
            full =
              fileName (objectText object)
                ++ ('.' : intercalate "-" (map ofVertex vertices))
                ++ ".svg"
        ofVertex = concatMap (escapedIn ".-") . fileName . vertexText

-- | The report of a drawing, given its file, the object, perhaps the face, the size of its symbols
-- relative to the paper's, and the symbols.
drawing :: FilePath -> ObjectName -> Maybe FaceName -> Rational -> [Stamp] -> MadeFile
drawing file object face scale stamps =
  MadeFile
    { madeFile = file,
      madeObject = object,
      madeFace = face,
      madeVertices = Nothing,
      madeTriangles = Nothing,
      madeVolume = Nothing,
      madeTaxels = sum (map stampArea stamps),
      madeStroke = scale * taxelPitch * fromIntegral (minimum (map stampStroke stamps)),
      madeHeight = Nothing,
      madeMostRounded = templateRounding
    }

-- | A name as part of a file's, different for different names.
fileName :: String -> FilePath
fileName = concatMap (escapedIn "/%")

-- | The character, by its number where it is one of these or no printable one.
escapedIn :: String -> Char -> String
escapedIn these c
  | c `elem` these || isControl c = '%' : showHex (ord c) ";"
  | otherwise = [c]
