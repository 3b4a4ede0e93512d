{-# LANGUAGE ForeignFunctionInterface #-}

-- | Which mutant is on, in the copy of the sources that @make mutate@ tests. It is no part of the
-- library.
module Mutant
  ( Site,
    site,
    chosen,
    recorded,

    -- * The file of records
    recordSize,
    recordAt,
  )
where

import Control.Monad (forM_)
import Data.Word (Word8)
import Foreign.C.Types (CInt (..), CSize (..))
import Foreign.Ptr (Ptr, nullPtr, plusPtr)
import Foreign.Storable (poke)
import System.Environment (lookupEnv)
import System.IO.Unsafe (unsafeDupablePerformIO, unsafePerformIO)
import System.Posix.IO (OpenMode (..), closeFd, defaultFileFlags, openFd)
import System.Posix.Types (COff (..), Fd (..))

-- | A site, as this process has it.
data Site = Site
  { -- | The variant that is on there, from 1; 0 is what stands in the sources, and -1 the same
    -- where it is recorded what comes to the site.
    chosen :: !Int,
    -- | Where that is recorded.
    siteMarks :: !(Ptr Word8)
  }

-- | A site by its number. The environment variable @PRA_TACTILE_MUTANT@ names the variant that is
-- on, as @SITE.VARIANT@. @PRA_TACTILE_MARKS=FILE@ is a file of 'recordSize' bytes, where all
-- processes record what they come to: of each site from 'recordAt' on whether it is reached, and
-- for each variant whether it ever differs from what stands there.
site :: Int -> Site
site number = unsafePerformIO $ do
  name <- lookupEnv "PRA_TACTILE_MUTANT"
  pure
    Site
      { chosen = case break (== '.') <$> name of
          Just (which, '.' : variant) | which == show number -> read variant
          _ | marks == nullPtr -> 0
          _ -> -1,
        siteMarks = marks `plusPtr` recordAt number
      }
{-# NOINLINE site #-}

-- | A value at a site, where it is recorded that it was evaluated, and which variants differ.
recorded :: Site -> [Bool] -> a -> a
recorded here differ value = unsafeDupablePerformIO $ do
  forM_ (zip [0 ..] (True : differ)) $ \(i, other) ->
    if other then poke (siteMarks here `plusPtr` i) (1 :: Word8) else pure ()
  pure value
{-# NOINLINE recorded #-}

-- | How many bytes the file has: eight for each of 2^20 sites.
recordSize :: Int
recordSize = 8 * 2 ^ (20 :: Int)

-- | The first byte of a site by its number. Two that share a place are both recorded where one is.
recordAt :: Int -> Int
recordAt number = (8 * number) `mod` recordSize

-- | The file of records in memory, or nothing where none is kept.
marks :: Ptr Word8
marks = unsafePerformIO $ do
  file <- lookupEnv "PRA_TACTILE_MARKS"
  case file of
    Nothing -> pure nullPtr
    Just name -> do
      fd <- openFd name ReadWrite Nothing defaultFileFlags
      -- To be read (1) and written (2), and shared (1).
      memory <- mmap nullPtr (fromIntegral recordSize) 3 1 fd 0
      memory <$ closeFd fd
{-# NOINLINE marks #-}

foreign import ccall unsafe "mmap"
  mmap :: Ptr Word8 -> CSize -> CInt -> CInt -> Fd -> COff -> IO (Ptr Word8)
